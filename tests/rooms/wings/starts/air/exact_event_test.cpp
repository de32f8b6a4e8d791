#include "starts/air/exact_event.hpp"

#include <cmath>
#include <tuple>

#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "scale.hpp"
#include "starts/answer/trace.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_trace_test::point;

namespace {

std::optional<Rational> corner_time(const Box& box) {
    const auto event = exact_event(box);
    return event && event->kind != Obstacle::graze ? event->time : std::nullopt;
}

// Whether a mass is at the floor or below it before the time at which both are.
bool touches_before(const Box& box, double time) {
    const auto at = [&](Axis axis) { return box.lower(axis).convert_to<double>(); };
    const double q = at(Axis::ratio);
    for (int i = 0; i < 10'000; ++i) {
        const double t = time * i / 10'000;
        const double sine = std::sin(at(Axis::phi) + at(Axis::phidot) * t);
        const double y = at(Axis::y) + at(Axis::ydot) * t;
        if (y + q / (1 + q) * sine <= 0 || y - sine / (1 + q) <= 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("a level rod without spin falls flat, and one that rises, or is a hair off level, does not") {
    CHECK(corner_time(point(0, 0, 3, -1, 10)) == Rational(3));
    CHECK(corner_time(point(0, 0, 3, -2, 10)) == Rational(3, 2));
    CHECK_FALSE(corner_time(point(0, 0, 3, 1, 10)));
    CHECK_FALSE(corner_time(point(Rational(1) / exact(0x1p300), 0, 3, -1, 10)));
    CHECK_FALSE(corner_time(point(Rational(314159265, 100000000), 0, 3, -1, 10)));
    CHECK_FALSE(corner_time(point(0, Rational(1, 10), 3, -1, 10)));
}

TEST_CASE("a rod that turns level just when it comes down falls flat, unless a mass touches before") {
    CHECK(corner_time(point(-1, 1, 1, -1, 10)) == Rational(1));
    CHECK(corner_time(point(1, -1, Rational(1, 2), Rational(-1, 2), 10)) == Rational(1));
    // The light mass leads, and is faster than the fall.
    CHECK_FALSE(corner_time(point(-1, 1, Rational(9, 10), Rational(-9, 10), 10)));
}

TEST_CASE("a box falls flat if all of it is level and does not turn, whatever its heights and mass ratios") {
    Box box = point(0, 0, 3, -1, 10);
    box.hi[1] = Rational(1, 100);
    CHECK_FALSE(exact_event(box));
    box.hi[1] = 0;
    box.hi[2] = 4;
    box.hi[4] = 20;
    REQUIRE(exact_event(box));
    CHECK(exact_event(box)->kind == Obstacle::flat);
    CHECK_FALSE(exact_event(box)->time);
    box.hi[3] = 0;
    CHECK_FALSE(exact_event(box));
    box.hi[3] = Rational(-1, 2);
    box.hi[0] = Rational(1, 100);
    CHECK_FALSE(exact_event(box));
}

TEST_CASE("multiples of pi are level exactly, their bounds are not") {
    Box box = point(3, 0, 3, -1, 10);
    std::tie(box.lo[0], box.hi[0]) = bounds({0, 1}, 128);
    CHECK_FALSE(exact_event(box));
    CHECK(exact_event(box, Angle{0, 1})->kind == Obstacle::flat);
    CHECK(exact_event(box, Angle{0, 1})->time == Rational(3));
    CHECK_FALSE(exact_event(box, Angle{0, Rational(1, 2)}));
    box.lo[1] = box.hi[1] = Rational(1, 7);
    CHECK_FALSE(exact_event(box, Angle{0, 1}));
}

TEST_CASE("a centre of mass that stays at the light mass's lever grazes, and only there") {
    for (const int q : {1, 10}) {
        const Rational beta2(q, 1 + q);
        CHECK(exact_event(point(0, 1, beta2, 0, q))->kind == Obstacle::graze);
        CHECK_FALSE(exact_event(point(0, 1, beta2, Rational(-1, 100), q)));
        CHECK_FALSE(exact_event(point(0, 1, beta2 + Rational(1, 100), 0, q)));
        CHECK_FALSE(exact_event(point(0, 1, beta2, 0, q + 1)));
    }
}

TEST_CASE("in a flat fall neither mass touches before, and no precision decides it") {
    const int stride = scaled(1) >= 20 ? 1 : 13;
    int found = 0, number = 0;
    for (int phi = -16; phi <= 16; ++phi) {
        for (int climb = 1; climb <= 12; ++climb) {
            for (const int q : {1, 2, 10, 1000}) {
                if (number++ % stride != 0) {
                    continue;
                }
                // Level at the time 1, where y = 0.
                const Rational ydot(-climb, 4);
                const Box box = point(Rational(phi, 4), Rational(-phi, 4), -ydot, ydot, q);
                const auto time = corner_time(box);
                const bool sooner = touches_before(box, 1);
                CAPTURE(phi, climb, q);
                CHECK_FALSE((time && sooner));
                if (std::abs(phi) <= 12) {  // decided exactly up to 3 radians
                    CHECK(time.has_value() != sooner);
                }
                if (time) {
                    ++found;
                    CHECK(*time == 1);
                    if (found % 100 == 1) {
                        CHECK_FALSE(trace(box, 30).exact());
                    }
                }
            }
        }
    }
    CHECK(found * stride > 300);
}
