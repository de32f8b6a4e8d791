// The certified witnesses of `certify`, traced as initial conditions.
#include "prove/witness.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "prove/initial_state.hpp"
#include "prove/trace.hpp"
#include "prove/witness_orbit.hpp"

using namespace dumbbell;

namespace {

/// A state in the air before the first collision, near the middle of its enclosure.
InitialBox before(const Collision<Interval>& first, const Rational& q) {
    const auto middle = [](const Interval& x) { return exact(approximate(x)); };
    const Rational phidot = middle(first.phidot_before);
    const Rational ydot = middle(first.ydot_before);
    const Rational y = middle(first.y);
    const Rational time = (Rational(1) - y) / -ydot;  // the incoming flight has come down from height 1
    const std::array<Rational, initial_axes> at{middle(first.phi) - phidot * time, phidot, Rational(1), ydot,
                                                q};
    return {at, at};
}

}  // namespace

TEST_CASE("Traced as initial conditions, witnesses have the collisions and margins that were certified") {
    for (const std::string ratio : {"2", "4", "10", "25", "100", "1000"}) {
        const Rational q = parse_rational(ratio);
        std::optional<Witness> witness;
        for (long target = 1; const auto better = find_witness<Interval>(q, q, target); ++target) {
            witness = better;
        }
        REQUIRE(witness);
        const auto orbit = witness_orbit(*witness, q, 256);
        REQUIRE(orbit.size() == static_cast<std::size_t>(witness->total()));
        const InitialBox start = before(orbit.front(), q);
        REQUIRE_NOTHROW(require_in_play(start));
        const Trace traced = trace(start, 30);
        INFO("q = " << ratio << ", witness of " << witness->total());
        REQUIRE(traced.exact());
        CHECK(traced.least == witness->total());
        REQUIRE(traced.collisions.size() == orbit.size());
        for (std::size_t i = 0; i < orbit.size(); ++i) {
            INFO("collision " << i + 1);
            CHECK(traced.collisions[i].heavy == orbit[i].heavy);
            CHECK(approximate(traced.collisions[i].grazing_sine.outward) ==
                  Approx(approximate(orbit[i].grazing_sine)).epsilon(1e-3).margin(1e-9));
        }
    }
}
