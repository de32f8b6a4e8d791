#include "collisions/section.hpp"

#include <catch2/catch.hpp>

#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

TEST_CASE("the root box holds the section: positions to pi/2, slopes r lambda to 1, the ratios") {
    for (const char* text : {"1", "1.0000001", "2", "2.0000001", "4.6", "1000000", "9/2", "1e300"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        const Box root = root_box(Chart::light, 1, q);
        CHECK(root.e_lo == 0);
        CHECK(root.e_hi == 2);
        CHECK(root.slope_lo == 0);
        CHECK(root.slope_hi >= q);  // lambda = q: slope 1
        CHECK(root.slope_hi < 2 * q);
        CHECK(root.q_lo == 1);
        CHECK(root.q_hi == q);
    }
}

TEST_CASE("the root's slopes end at the least power of two that reaches the greatest ratio") {
    CHECK(root_box(Chart::light, 1, 1).slope_hi == 1);
    CHECK(root_box(Chart::light, 1, 2).slope_hi == 2);
    CHECK(root_box(Chart::light, 2, parse_rational("2.5")).slope_hi == 4);
    CHECK(root_box(Chart::light, 64, 64).slope_hi == 64);
    CHECK(root_box(Chart::light, 64, 65).slope_hi == 128);
}

TEST_CASE("halves share their exact midpoint and nothing else, down to 400 splits") {
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio}) {
        Box box = root_box(Chart::light, parse_rational("10/3"), parse_rational("7"));
        for (int depth = 0; depth < 400; ++depth) {
            const std::pair<Box, Box> both = halves(box, axis);
            const Box& lower = both.first;
            const Box& upper = both.second;
            const auto spans = [&](Rational Box::*lo, Rational Box::*hi, Axis which) {
                REQUIRE(lower.*lo == box.*lo);
                REQUIRE(upper.*hi == box.*hi);
                if (which == axis) {
                    REQUIRE(lower.*hi == upper.*lo);
                    REQUIRE(lower.*hi * 2 == box.*lo + box.*hi);
                } else {
                    REQUIRE(lower.*hi == box.*hi);
                    REQUIRE(upper.*lo == box.*lo);
                }
            };
            spans(&Box::e_lo, &Box::e_hi, Axis::position);
            spans(&Box::slope_lo, &Box::slope_hi, Axis::slope);
            spans(&Box::q_lo, &Box::q_hi, Axis::ratio);
            box = depth % 3 == 0 ? upper : lower;
        }
    }
}
