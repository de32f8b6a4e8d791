#include "collisions/chart.hpp"

#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

TEST_CASE("the root box holds the section: positions to pi/2, slopes r lambda to 1, the ratios") {
    for (const char* text : {"1", "1.0000001", "2", "2.0000001", "4.6", "1000000", "9/2", "1e300"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        const Box root = root_box(Chart::light, 1, q);
        CHECK(Rational(root[Axis::position].lo) == 0);
        CHECK(Rational(root[Axis::position].hi) == 2);
        CHECK(Rational(root[Axis::slope].lo) == 0);
        CHECK(Rational(root[Axis::slope].hi) >= q);  // lambda = q: slope 1
        CHECK(Rational(root[Axis::slope].hi) < 2 * q);
        CHECK(Rational(root[Axis::ratio].lo) == 1);
        CHECK(Rational(root[Axis::ratio].hi) == q);
    }
}

TEST_CASE("the root's slopes end at the least power of two that reaches the greatest ratio") {
    CHECK(Rational(root_box(Chart::light, 1, 1)[Axis::slope].hi) == 1);
    CHECK(Rational(root_box(Chart::light, 1, 2)[Axis::slope].hi) == 2);
    CHECK(Rational(root_box(Chart::light, 2, parse_rational("2.5"))[Axis::slope].hi) == 4);
    CHECK(Rational(root_box(Chart::light, 64, 64)[Axis::slope].hi) == 64);
    CHECK(Rational(root_box(Chart::light, 64, 65)[Axis::slope].hi) == 128);
}

TEST_CASE("halves share their exact midpoint and nothing else, down to 400 splits") {
    for (const Axis axis : all_axes) {
        Box box = root_box(Chart::light, parse_rational("10/3"), parse_rational("7"));
        for (int depth = 0; depth < 400; ++depth) {
            const std::pair<Box, Box> both = halves(box, axis);
            for (const Axis which : all_axes) {
                const std::pair<Rational, Rational> whole(box[which].lo, box[which].hi);
                const std::pair<Rational, Rational> lower(both.first[which].lo, both.first[which].hi);
                const std::pair<Rational, Rational> upper(both.second[which].lo, both.second[which].hi);
                REQUIRE(lower.first == whole.first);
                REQUIRE(upper.second == whole.second);
                if (which == axis) {
                    REQUIRE(lower.second == upper.first);
                    REQUIRE(lower.second * 2 == whole.first + whole.second);
                } else {
                    REQUIRE(lower.second == whole.second);
                    REQUIRE(upper.first == whole.first);
                }
            }
            box = depth % 3 == 0 ? both.second : both.first;
        }
    }
}
