// Starts of bodies with mass between their contacts (L77), against the simulation of tests/attacks/oracle.
#include <algorithm>
#include <map>

#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/trial.hpp"
#include "box.hpp"
#include "catch.hpp"
#include "starts/incoming.hpp"
#include "starts/leaf.hpp"
#include "starts/shares.hpp"
#include "starts/subdivide.hpp"
#include "starts/trace.hpp"

namespace {

using dumbbell::parse_rational;
using dumbbell::Rational;
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

struct Numbers {
    const char *rho, *q;
};
constexpr Numbers coin{"1", "4"};
constexpr Numbers tried[] = {coin,         {"1", "3"},     {"211/2011", "12132363/1248521"},
                             {"1/2", "3"}, {"9/10", "30"}, {"1/100", "101"},
                             {"1/3", "3"}};

Dumbbell<Real> physical(const Numbers& of) {
    const Real rho = parse_rational(of.rho).convert_to<Real>(), q = parse_rational(of.q).convert_to<Real>();
    const Real far = 1 / (1 + rho);
    return {far, rho * far, far * far / q};
}

/// The sides as starts of this body.
Box box_of(const Sides& sides, const Numbers& of) {
    Box box = sides.box();
    box.lo[4] = box.hi[4] = parse_rational(of.q);
    box.rho = parse_rational(of.rho);
    return box;
}

}  // namespace

TEST_CASE("L77: starts of bodies have the collisions that are traced, and as many as a box of them says") {
    const auto in = [](const TracedValue& value, Real x) { return holds(value, x, 1e-11L); };
    std::mt19937_64 engine(20261127);
    long checked = 0, exact = 0, boxes = 0;
    for (int i = 0; i < dumbbell_oracle::trials(1400); ++i) {
        const Numbers& numbers = tried[i % std::size(tried)];
        const Sides sides = random_sides(engine, 1, std::pow(10.0, -uniform(engine, 1, 6)));
        const Box box = box_of(sides, numbers);
        const auto traced = dumbbell::starts::trace(box, 0);
        const auto leaf = dumbbell::starts::judge(box, 53);
        ++boxes;
        exact += leaf.most == leaf.least ? 1 : 0;
        for (int j = 0; j < 10; ++j) {
            const State<Real> start = random_start(engine, sides);
            const auto run = dumbbell_oracle::simulate(physical(numbers), start);
            if (run.care.doubtful()) {
                continue;
            }
            ++checked;
            const auto& all = run.collisions;
            const auto count = static_cast<long>(all.size());
            INFO(dumbbell_oracle::say("rho", numbers.rho, "Q", numbers.q, "point", start.phi, start.phidot,
                                      start.y, start.ydot, "count", count));
            REQUIRE((traced.least <= count && (!traced.most || count <= *traced.most)));
            REQUIRE((leaf.least <= count && (!leaf.most || count <= *leaf.most)));
            REQUIRE((!leaf.first || leaf.first->heavy == (all.front().mass == Mass::heavy)));
            for (std::size_t k = 0; k < traced.collisions.size(); ++k) {
                const auto& bounds = traced.collisions[k];
                REQUIRE(bounds.heavy == (all.at(k).mass == Mass::heavy));
                REQUIRE((in(bounds.time, all[k].time) && in(bounds.phi, all[k].before.phi) &&
                         in(bounds.y, all[k].before.y) && in(bounds.ydot_after, all[k].after.ydot) &&
                         in(bounds.phidot_after, all[k].after.phidot)));
            }
        }
    }
    CHECK(checked > 5 * boxes);
    CHECK(exact > boxes / 2);
}

TEST_CASE("A single start of a body is followed to its end") {
    std::mt19937_64 engine(5);
    long decided = 0, tries = 0;
    for (const Numbers& numbers : tried) {
        for (int i = 0; i < 40; ++i) {
            const auto traced = dumbbell::starts::trace(box_of(random_sides(engine, 1, 0), numbers), 0);
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
        box.rho = Rational(1, 3);
        const auto body = dumbbell::starts::trace(box, 0);
        REQUIRE(body.least == massless.least);
        REQUIRE(body.collisions.size() == massless.collisions.size());
    }
}

TEST_CASE("L77: the shares of all incoming motions of a body hold in a random sample of them") {
    for (const Numbers& numbers : {coin, Numbers{"1/2", "3"}}) {
        const Rational rho = parse_rational(numbers.rho);
        const Box all = dumbbell::starts::incoming_box(parse_rational(numbers.q), rho);
        const auto parts = subdivide(all, {.max_boxes = 3000, .jobs = 2, .incoming = true});
        std::mt19937_64 engine(7);
        std::map<long, long> found;
        const int samples = dumbbell_oracle::trials(4000);
        for (int i = 0; i < samples; ++i) {
            const Real s = uniform(engine, 0, 1), q = parse_rational(numbers.q).convert_to<Real>();
            const Real far = 1 / (1 + rho.convert_to<Real>());
            const State<Real> start{uniform(engine, 0, 6.283185307179586), s * std::sqrt(q / (1 - s * s)),
                                    far * (1 + 0x1p-20L), -far};
            ++found[static_cast<long>(dumbbell_oracle::simulate(physical(numbers), start).collisions.size())];
        }
        for (const auto& bounds : share_bounds(parts.tree)) {
            const bool is_one = bounds.most == bounds.least;
            const double lo = bounds.lo.convert_to<double>(), hi = bounds.hi.convert_to<double>();
            const double share = static_cast<double>(found[bounds.least]) / samples;
            const double chance = 5 * std::sqrt(0.25 / samples);
            INFO(bounds.least << ": " << share << " in [" << lo << ", " << hi << "]");
            CHECK((!is_one || (lo - chance <= share && share <= hi + chance)));
        }
        CHECK(parts.undecided.share < Rational(1, 3));
        CHECK(*parts.most >= found.rbegin()->first);
    }
}
