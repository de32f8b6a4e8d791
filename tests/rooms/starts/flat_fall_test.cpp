#include "starts/flat_fall.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "starts/trace.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

InitialBox point(const Rational& phi, const Rational& phidot, const Rational& y, const Rational& ydot,
                 const Rational& q) {
    const std::array<Rational, initial_axes> at{phi, phidot, y, ydot, q};
    return {at, at};
}

// Whether a mass is at the floor or below it before the time at which both are.
bool touches_before(const InitialBox& box, double time) {
    const auto at = [&](InitialAxis axis) { return box.lower(axis).convert_to<double>(); };
    const double q = at(InitialAxis::ratio);
    for (int i = 0; i < 10'000; ++i) {
        const double t = time * i / 10'000;
        const double sine = std::sin(at(InitialAxis::phi) + at(InitialAxis::phidot) * t);
        const double y = at(InitialAxis::y) + at(InitialAxis::ydot) * t;
        if (y + q / (1 + q) * sine <= 0 || y - sine / (1 + q) <= 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("a level rod without spin falls flat; one that rises, or is a hair off level, does not") {
    CHECK(flat_fall(point(0, 0, 3, -1, 10)) == Rational(3));
    CHECK(flat_fall(point(0, 0, 3, -2, 10)) == Rational(3, 2));
    CHECK_FALSE(flat_fall(point(0, 0, 3, 1, 10)));
    CHECK_FALSE(flat_fall(point(Rational(1) / exact(0x1p300), 0, 3, -1, 10)));
    CHECK_FALSE(flat_fall(point(Rational(314159265, 100000000), 0, 3, -1, 10)));
    CHECK_FALSE(flat_fall(point(0, Rational(1, 10), 3, -1, 10)));
}

TEST_CASE("a rod that turns level just when it comes down falls flat, unless a mass touches before") {
    CHECK(flat_fall(point(-1, 1, 1, -1, 10)) == Rational(1));
    CHECK(flat_fall(point(1, -1, Rational(1, 2), Rational(-1, 2), 10)) == Rational(1));
    // The light mass leads, and is faster than the fall.
    CHECK_FALSE(flat_fall(point(-1, 1, Rational(9, 10), Rational(-9, 10), 10)));
}

TEST_CASE("no box falls flat") {
    InitialBox box = point(0, 0, 3, -1, 10);
    box.hi[1] = Rational(1, 100);
    CHECK_FALSE(flat_fall(box));
}

TEST_CASE("in a flat fall neither mass touches before, and no precision decides it") {
    int found = 0;
    for (int phi = -16; phi <= 16; ++phi) {
        for (int climb = 1; climb <= 12; ++climb) {
            for (const int q : {1, 2, 10, 1000}) {
                // Level at the time 1, where y = 0.
                const Rational ydot(-climb, 4);
                const InitialBox box = point(Rational(phi, 4), Rational(-phi, 4), -ydot, ydot, q);
                const auto time = flat_fall(box);
                const bool sooner = touches_before(box, 1);
                CAPTURE(phi, climb, q);
                CHECK_FALSE((time && sooner));
                if (std::abs(phi) <= 12) {  // decided exactly up to 3 radians
                    CHECK(time.has_value() != sooner);
                }
                if (time) {
                    ++found;
                    CHECK(*time == 1);
                    if (found % 100 == 0) {
                        CHECK_FALSE(trace(box, 30).exact());
                    }
                }
            }
        }
    }
    CHECK(found > 300);
}
