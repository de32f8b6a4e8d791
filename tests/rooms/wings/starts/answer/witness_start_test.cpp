// The certified witnesses of `certify`, traced as initial conditions.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "catch.hpp"
#include "collisions/witness.hpp"
#include "collisions/witness_orbit.hpp"
#include "starts/air/box_state.hpp"
#include "starts/answer/trace.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell::collisions::find_witness;
using dumbbell::collisions::Witness;
using dumbbell::flight::Collision;

namespace {

/// A state in the air before the first collision, near the middle of its enclosure.
Box before(const Collision<Interval>& first, const Rational& q) {
    const auto middle = [](const Interval& x) { return exact(approximate(x)); };
    const Rational phidot = middle(first.phidot_before);
    const Rational ydot = middle(first.ydot_before);
    const Rational y = middle(first.y);
    const Rational time = (Rational(1) - y) / -ydot;  // the incoming flight has come down from height 1
    const std::array<Rational, axis_count> at{middle(first.phi) - phidot * time, phidot, Rational(1), ydot,
                                              q};
    return {at, at};
}

/// The best witness that doubles find: its orbit bears being rounded to double.
Witness best_witness(const Rational& q) {
    const PrecisionScope scope(53);
    std::optional<Witness> witness;
    while (const auto better = find_witness<Interval>(q, q, witness ? witness->total() + 1 : 1)) {
        witness = better;
    }
    REQUIRE(witness);
    return *witness;
}

Box start_of(const Witness& witness, const Rational& q) {
    const auto orbit = witness_orbit(witness, q, 512);
    REQUIRE(orbit.size() == static_cast<std::size_t>(as_long(witness.total())));
    return before(orbit.front(), q);
}

bool overlap(const TracedValue& a, const TracedValue& b) {
    return a.outward.lo() <= b.outward.hi() && b.outward.lo() <= a.outward.hi();
}

bool overlap(const Collision<TracedValue>& a, const Collision<TracedValue>& b) {
    return a.heavy == b.heavy && overlap(a.time, b.time) && overlap(a.phi, b.phi) && overlap(a.y, b.y) &&
           overlap(a.phidot_before, b.phidot_before) && overlap(a.phidot_after, b.phidot_after) &&
           overlap(a.ydot_before, b.ydot_before) && overlap(a.ydot_after, b.ydot_after);
}

}  // namespace

TEST_CASE("Traced as initial conditions, witnesses have the collisions and margins that were certified") {
    for (const std::string ratio : {"2", "4", "10", "25", "100", "1000"}) {
        const Rational q = parse_rational(ratio);
        const Witness witness = best_witness(q);
        const auto orbit = witness_orbit(witness, q, 256);
        REQUIRE(orbit.size() == static_cast<std::size_t>(as_long(witness.total())));
        const Box start = before(orbit.front(), q);
        REQUIRE_NOTHROW(require_in_play(start));
        const Trace traced = trace(start, 30);
        INFO("q = " << ratio << ", witness of " << witness.total());
        REQUIRE(traced.exact());
        CHECK(traced.least == witness.total());
        REQUIRE(traced.collisions.size() == orbit.size());
        for (std::size_t i = 0; i < orbit.size(); ++i) {
            INFO("collision " << i + 1);
            CHECK(traced.collisions[i].heavy == orbit[i].heavy);
            CHECK(approximate(traced.collisions[i].grazing_sine.outward) ==
                  Approx(approximate(orbit[i].grazing_sine)).epsilon(1e-3).margin(1e-9));
        }
    }
}

TEST_CASE("In double precision every collision of the longest orbits is enclosed") {
    for (const auto& [ratio, least] :
         {std::pair("10", 4L), std::pair("10000", 90L), std::pair("1e6", 880L)}) {
        INFO("q = " << ratio);
        const Rational q = parse_rational(ratio);
        const Witness witness = best_witness(q);
        CHECK(witness.total() >= least);
        const Box start = start_of(witness, q);
        const Trace traced = trace(start, 0);
        REQUIRE(traced.exact());
        CHECK(traced.least == witness.total());
        REQUIRE(traced.collisions.size() == static_cast<std::size_t>(traced.least));
        CHECK(width(traced.collisions.back().phidot_after.outward) < 1e-3);
        if (q > 100'000) {
            continue;
        }
        const Trace fine = trace(start, 30);
        REQUIRE(fine.collisions.size() == traced.collisions.size());
        for (std::size_t i = 0; i < traced.collisions.size(); ++i) {
            INFO("collision " << i + 1);
            REQUIRE(overlap(traced.collisions[i], fine.collisions[i]));
        }
    }
}

TEST_CASE("Boxes around a long orbit share many enclosed collisions, those of their points") {
    const Rational q(10'000);
    const Box start = start_of(best_witness(q), q);
    const auto around = [&](const Rational& radius) {
        Box box = start;
        for (std::size_t i = 0; i < axis_count; ++i) {
            const bool varies = static_cast<Axis>(i) != Axis::ratio;
            box.lo[i] -= varies ? radius : Rational(0);
            box.hi[i] += varies ? radius : Rational(0);
        }
        return box;
    };
    for (const auto& [size, least] : {std::pair(1e-9, 90U), std::pair(1e-6, 40U)}) {
        INFO("width " << size);
        const Box box = around(exact(size) / 2);
        const Trace traced = trace(box, 0);
        CHECK(traced.collisions.size() >= least);
        for (unsigned corner = 0; corner < 16; ++corner) {
            Box point = box;
            for (std::size_t i = 0; i < axis_count; ++i) {
                const bool up = (corner >> i & 1U) != 0;
                point.lo[i] = point.hi[i] = up ? box.hi[i] : box.lo[i];
            }
            const Trace inside = trace(point, 0);
            INFO("corner " << corner);
            REQUIRE(inside.collisions.size() >= traced.collisions.size());
            for (std::size_t i = 0; i < traced.collisions.size(); ++i) {
                INFO("collision " << i + 1);
                REQUIRE(overlap(traced.collisions[i], inside.collisions[i]));
            }
        }
    }
}
