#include "collisions/section.hpp"

#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

TEST_CASE("the root box holds the section: positions to pi/2, slopes r lambda to 1, the ratios") {
    for (const char* text : {"1", "1.0000001", "2", "2.0000001", "4.6", "1000000", "9/2", "1e300"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        const Box root = root_box(Chart::light, 1, q);
        CHECK(Rational(root.e_lo) == 0);
        CHECK(Rational(root.e_hi) == 2);
        CHECK(Rational(root.slope_lo) == 0);
        CHECK(Rational(root.slope_hi) >= q);  // lambda = q: slope 1
        CHECK(Rational(root.slope_hi) < 2 * q);
        CHECK(Rational(root.q_lo) == 1);
        CHECK(Rational(root.q_hi) == q);
    }
}

TEST_CASE("the root's slopes end at the least power of two that reaches the greatest ratio") {
    CHECK(Rational(root_box(Chart::light, 1, 1).slope_hi) == 1);
    CHECK(Rational(root_box(Chart::light, 1, 2).slope_hi) == 2);
    CHECK(Rational(root_box(Chart::light, 2, parse_rational("2.5")).slope_hi) == 4);
    CHECK(Rational(root_box(Chart::light, 64, 64).slope_hi) == 64);
    CHECK(Rational(root_box(Chart::light, 64, 65).slope_hi) == 128);
}

TEST_CASE("halves share their exact midpoint and nothing else, down to 400 splits") {
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio, Axis::rho}) {
        Box box = root_box(Chart::light, parse_rational("10/3"), parse_rational("7"));
        box.rho_lo = parse_rational("1/3");
        box.rho_hi = parse_rational("2/5");
        for (int depth = 0; depth < 400; ++depth) {
            const std::pair<Box, Box> both = halves(box, axis);
            const auto spans = [&](Coordinate Box::*lo, Coordinate Box::*hi, Axis which) {
                const std::pair<Rational, Rational> whole(box.*lo, box.*hi);
                const std::pair<Rational, Rational> lower(both.first.*lo, both.first.*hi);
                const std::pair<Rational, Rational> upper(both.second.*lo, both.second.*hi);
                REQUIRE(lower.first == whole.first);
                REQUIRE(upper.second == whole.second);
                if (which == axis) {
                    REQUIRE(lower.second == upper.first);
                    REQUIRE(lower.second * 2 == whole.first + whole.second);
                } else {
                    REQUIRE(lower.second == whole.second);
                    REQUIRE(upper.first == whole.first);
                }
            };
            spans(&Box::e_lo, &Box::e_hi, Axis::position);
            spans(&Box::slope_lo, &Box::slope_hi, Axis::slope);
            spans(&Box::q_lo, &Box::q_hi, Axis::ratio);
            spans(&Box::rho_lo, &Box::rho_hi, Axis::rho);
            box = depth % 3 == 0 ? both.second : both.first;
        }
    }
}
