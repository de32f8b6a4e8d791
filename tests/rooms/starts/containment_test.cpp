// Simulated orbits (tests/attacks/oracle: another program, other formulas) of random initial conditions lie
// in what `trace` says of the box around them. (What `--subdivide` says: soundness_test.cpp.)
#include <algorithm>

#include "attacks/oracle/scalar.hpp"
#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/trial.hpp"
#include "box.hpp"
#include "catch.hpp"
#include "starts/box_state.hpp"
#include "starts/trace.hpp"

namespace {

using dumbbell::flight::Collision;
using dumbbell::starts::TracedValue;
using dumbbell_oracle::Dumbbell;
using dumbbell_oracle::Mass;
using dumbbell_oracle::Real;
using dumbbell_oracle::State;
using dumbbell_trace_test::holds;
using dumbbell_trace_test::random_sides;
using dumbbell_trace_test::random_start;
using dumbbell_trace_test::Sides;
using dumbbell_trace_test::uniform;

template <class S>
bool holds(const Collision<TracedValue>& traced, const dumbbell_oracle::Collision<S>& simulated) {
    const auto in = [](const TracedValue& value, const S& x) { return holds(value, static_cast<Real>(x)); };
    return traced.heavy == (simulated.mass == Mass::heavy) && in(traced.time, simulated.time) &&
           in(traced.phi, simulated.before.phi) && in(traced.y, simulated.before.y) &&
           in(traced.ydot_before, simulated.before.ydot) && in(traced.ydot_after, simulated.after.ydot) &&
           in(traced.phidot_before, simulated.before.phidot) &&
           in(traced.phidot_after, simulated.after.phidot);
}

template <class S>
bool hold(const std::vector<Collision<TracedValue>>& traced,
          const std::vector<dumbbell_oracle::Collision<S>>& simulated) {
    return traced.size() <= simulated.size() &&
           std::equal(traced.begin(), traced.end(), simulated.begin(),
                      [](const auto& t, const auto& s) { return holds(t, s); });
}

/// The orbit again with 80 digits: the simulation divides angles by phidot, and where that is tiny its times
/// in long double are worth less than the tolerance.
bool hold_with_80_digits(const std::vector<Collision<TracedValue>>& traced, double q,
                         const State<Real>& start) {
    using dumbbell_oracle::Digits80;
    const Dumbbell<Digits80> body{Digits80(q)};
    const State<Digits80> same{Digits80(start.phi), Digits80(start.phidot), Digits80(start.y),
                               Digits80(start.ydot)};
    return hold(traced, dumbbell_oracle::simulate(body, same).collisions);
}

std::string describe(const Sides& s) {
    return dumbbell_oracle::say("q", s.q, "phi", s.phi_lo, s.phi_hi, "phidot", s.phidot_lo, s.phidot_hi, "y",
                                s.y_lo, s.y_hi, "ydot", s.ydot_lo, s.ydot_hi);
}

constexpr double tried_ratios[] = {1, 1.5, 3, 10, 100, 10000};

}  // namespace

TEST_CASE("10,000 random boxes contain the simulated orbits of their points") {
    std::mt19937_64 engine(20260801);
    long checked = 0;
    for (int i = 0; i < dumbbell_oracle::trials(10000); ++i) {
        const double q = tried_ratios[i % 6];
        const Sides sides = random_sides(engine, q, std::pow(10.0, -uniform(engine, 1, 8)));
        const auto traced = dumbbell::starts::trace(sides.box(), 0);
        const Dumbbell<Real> body(q);
        for (int j = 0; j < 10; ++j) {
            const State<Real> start = random_start(engine, sides);
            const auto run = dumbbell_oracle::simulate(body, start);
            if (run.care.doubtful()) {
                continue;
            }
            ++checked;
            const auto count = static_cast<long>(run.collisions.size());
            INFO(describe(sides));
            INFO(dumbbell_oracle::say("point", start.phi, start.phidot, start.y, start.ydot, "count", count));
            REQUIRE(traced.least <= count);
            REQUIRE((!traced.most || count <= *traced.most));
            REQUIRE((hold(traced.collisions, run.collisions) ||
                     hold_with_80_digits(traced.collisions, q, start)));
        }
    }
    CHECK(checked > 90000);
}

TEST_CASE("In double precision every collision of random starts is enclosed, also at great mass ratios") {
    for (const double q : {10.0, 1e4, 1e6}) {
        std::mt19937_64 engine(20261121);
        long collisions = 0;
        for (int i = 0; i < dumbbell_oracle::trials(400); ++i) {
            const Sides sides = random_sides(engine, q, 0);
            const auto traced = dumbbell::starts::trace(sides.box(), 0);
            INFO(describe(sides));
            REQUIRE(traced.exact());
            REQUIRE(traced.collisions.size() == static_cast<std::size_t>(traced.least));
            collisions += traced.least;
            if (i % 20 == 0 || traced.least > 20) {
                REQUIRE(hold_with_80_digits(traced.collisions, q,
                                            {sides.phi_lo, sides.phidot_lo, sides.y_lo, sides.ydot_lo}));
            }
        }
        CHECK(collisions > 0);
    }
}

TEST_CASE("Orbits in double precision and with more digits overlap, and decide nearly every random point") {
    for (const double q : {10.0, 100.0, 10000.0}) {
        std::mt19937_64 engine(99);
        long decided = 0;
        const int points = dumbbell_oracle::trials(4000);
        for (int i = 0; i < points; ++i) {
            const auto box = random_sides(engine, q, 0).box();
            const auto traced = dumbbell::starts::trace(box, 0);
            decided += traced.exact() ? 1 : 0;
            if (i % 200 == 0 || !traced.exact()) {
                const auto fine = dumbbell::starts::trace(box, 40);
                INFO("point " << i << " of q = " << q);
                REQUIRE(fine.exact());
                REQUIRE(fine.bits <= 300);
                REQUIRE(traced.least <= fine.least);
                REQUIRE(fine.least <= *traced.most);
                for (std::size_t k = 0; k < traced.collisions.size(); ++k) {
                    const auto& a = traced.collisions[k].phidot_after.outward;
                    const auto& b = fine.collisions[k].phidot_after.outward;
                    REQUIRE(std::max(a.lo(), b.lo()) <= std::min(a.hi(), b.hi()));
                }
            }
        }
        INFO("q = " << q << ": decided " << decided << " of " << points);
        CHECK(decided >= points / 100 * 99);
    }
}
