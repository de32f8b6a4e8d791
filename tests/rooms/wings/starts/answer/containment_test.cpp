// Simulated orbits (tests/attacks/oracle: another program, other formulas) of random initial conditions lie
// in what `trace` says of the box around them. (What `--subdivide` says: soundness_test.cpp.)
#include <algorithm>

#include "attacks/oracle/scalar.hpp"
#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/trial.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "starts/air/box_state.hpp"
#include "starts/answer/trace.hpp"
#include "starts/cover/leaf.hpp"

namespace {

using dumbbell::flight::Collision;
using dumbbell::starts::Box;
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

/// A body by its two numbers; a massless dumbbell of the mass ratio q if rho is 0.
struct Numbers {
    double rho, q;
};

template <class S>
Dumbbell<S> physical(const Numbers& of) {
    const S rho = of.rho > 0 ? S(of.rho) : 1 / S(of.q);
    const S far = 1 / (1 + rho);
    return {far, rho * far, far * far / S(of.q)};
}

Box box_of(const Sides& sides, const Numbers& of) {
    Box box = sides.box();
    if (of.rho > 0) {
        box.rho = dumbbell::exact(of.rho);
    }
    return box;
}

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
bool hold_with_80_digits(const std::vector<Collision<TracedValue>>& traced, const Numbers& body,
                         const State<Real>& start) {
    using dumbbell_oracle::Digits80;
    const State<Digits80> same{Digits80(start.phi), Digits80(start.phidot), Digits80(start.y),
                               Digits80(start.ydot)};
    return hold(traced, dumbbell_oracle::simulate(physical<Digits80>(body), same).collisions);
}

std::string describe(const Sides& s) {
    return dumbbell_oracle::say("q", s.q, "phi", s.phi_lo, s.phi_hi, "phidot", s.phidot_lo, s.phidot_hi, "y",
                                s.y_lo, s.y_hi, "ydot", s.ydot_lo, s.ydot_hi);
}

constexpr Numbers tried[] = {{0, 1},          {0, 1.5}, {0, 3},      {0, 10},    {0, 100}, {0, 10000},
                             {0, 1e6},        {1, 4},   {1, 3},      {0.125, 9}, {0.5, 3}, {0.875, 30},
                             {0.015625, 101}, {1, 0.5}, {0.5, 0.25}, {0.25, 2}};

}  // namespace

TEST_CASE("L77: random boxes contain the simulated orbits of their points, of dumbbells and bodies") {
    std::mt19937_64 engine(20260801);
    long checked = 0, exact = 0;
    const long boxes = scaled(1'200);
    for (int i = 0; i < boxes; ++i) {
        const Numbers& numbers = tried[i % std::size(tried)];
        const Sides sides = random_sides(engine, numbers.q, std::pow(10.0, -uniform(engine, 1, 8)));
        const Box box = box_of(sides, numbers);
        const auto traced = dumbbell::starts::trace(box, 0);
        const auto leaf = dumbbell::starts::judge(box, 53);
        exact += leaf.most == leaf.least ? 1 : 0;
        for (int j = 0; j < 10; ++j) {
            const State<Real> start = random_start(engine, sides);
            const auto run = dumbbell_oracle::simulate(physical<Real>(numbers), start);
            if (run.care.doubtful()) {
                continue;
            }
            ++checked;
            const auto count = static_cast<long>(run.collisions.size());
            INFO(describe(sides) << " rho " << numbers.rho);
            INFO(dumbbell_oracle::say("point", start.phi, start.phidot, start.y, start.ydot, "count", count));
            REQUIRE((traced.least <= count && (!traced.most || count <= *traced.most)));
            REQUIRE((leaf.least <= count && (!leaf.most || count <= *leaf.most)));
            REQUIRE((!leaf.first || leaf.first->heavy == (run.collisions.front().mass == Mass::heavy)));
            REQUIRE((hold(traced.collisions, run.collisions) ||
                     hold_with_80_digits(traced.collisions, numbers, start)));
        }
    }
    CHECK(checked > 9 * boxes);
    CHECK(exact > boxes / 2);
}

TEST_CASE("A single start of a body is followed to its end") {
    std::mt19937_64 engine(5);
    long decided = 0, tries = 0;
    for (const Numbers& numbers : tried) {
        for (int i = 0; i < 40; ++i) {
            const auto traced =
                dumbbell::starts::trace(box_of(random_sides(engine, numbers.q, 0), numbers), 0);
            ++tries;
            decided +=
                traced.exact() && traced.collisions.size() == static_cast<std::size_t>(traced.least) ? 1 : 0;
        }
    }
    CHECK(decided >= tries - 2);
}

TEST_CASE("With all mass at the contacts a body's starts are the massless dumbbell's") {
    std::mt19937_64 engine(6);
    for (int i = 0; i < 100; ++i) {
        Box box = random_sides(engine, 3, 0).box();
        const auto massless = dumbbell::starts::trace(box, 0);
        box.rho = dumbbell::Rational(1, 3);
        const auto body = dumbbell::starts::trace(box, 0);
        REQUIRE(body.least == massless.least);
        REQUIRE(body.collisions.size() == massless.collisions.size());
    }
}

TEST_CASE("Orbits in double precision and with more digits overlap, and decide nearly every random point") {
    for (const double q : {10.0, 100.0, 10000.0}) {
        std::mt19937_64 engine(99);
        long decided = 0;
        const long points = scaled(800);
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
