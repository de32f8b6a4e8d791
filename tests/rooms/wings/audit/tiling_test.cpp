#include "audit/tiling.hpp"

#include "catch.hpp"
#include "collisions/leaf_boxes.hpp"
#include "rooms/collisions/random_tree.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;
using dumbbell::audit::check_tiling;
using dumbbell::audit::Fault;
using dumbbell::audit::Tiling;

namespace {

/// Splits `axis` again and again towards `upper` or the lower end: leaves whose sizes halve.
Tree chain(const std::vector<Axis>& turns, int depth, bool upper) {
    Tree tree;
    for (int i = 0; i < depth; ++i) {
        tree.push_back(split(turns[static_cast<std::size_t>(i) % turns.size()]));
        if (upper) {
            tree.push_back(leaf());
        }
    }
    tree.push_back(leaf());
    if (!upper) {
        tree.insert(tree.end(), static_cast<std::size_t>(depth), leaf());
    }
    return tree;
}

/// Towards 1/3 of the axis: lower and upper by turns, where doubles cannot tell the last leaves apart.
Tree zigzag(Axis axis, int depth) {
    Tree tree{leaf()};
    for (int i = depth; i-- > 0;) {
        Tree outer{split(axis)};
        if (i % 2 == 1) {
            outer.push_back(leaf());
        }
        outer.insert(outer.end(), tree.begin(), tree.end());
        if (i % 2 == 0) {
            outer.push_back(leaf());
        }
        tree = std::move(outer);
    }
    return tree;
}

void check_tiles(const Boxes& boxes) {
    const Tiling tiling = check_tiling(boxes);
    CHECK_FALSE(tiling.fault);
    CHECK(tiling.leaves == boxes.leaves.size());
    CHECK(tiling.missing == 0);
}

Boxes random_boxes(unsigned seed) {
    return leaf_boxes(Chart::bridge, 10, 13, random_tree(200, three_axes, seed));
}

}  // namespace

TEST_CASE("complete trees tile") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        check_tiles(random_boxes(seed));
        check_tiles(
            leaf_boxes(Chart::contact, Rational(10, 7), Rational(11, 7), random_tree(200, plane_axes, seed)));
        check_tiles(
            leaf_boxes(Chart::light, Rational(10, 7), Rational(10, 7), random_tree(200, plane_axes, seed)));
        check_tiles(leaf_boxes(Chart::bridge, 3, 3, random_tree(200, {Axis::slope}, seed)));
    }
}

TEST_CASE("a root alone tiles itself") {
    const Tiling tiling = check_tiling(leaf_boxes(Chart::bridge, 10, 13, {leaf()}));
    CHECK_FALSE(tiling.fault);
    CHECK(tiling.area == 2 * 16 * 3);
    CHECK(tiling.pairs == 0);
}

TEST_CASE("deep splits tile") {
    for (const bool upper : {false, true}) {
        check_tiles(leaf_boxes(Chart::bridge, 10, 10, chain({Axis::position}, 400, upper)));
        check_tiles(leaf_boxes(Chart::bridge, 10, Rational(31, 3), chain(three_axes, 1200, upper)));
    }
    check_tiles(leaf_boxes(Chart::light, 10, 10, zigzag(Axis::slope, 400)));
    check_tiles(leaf_boxes(Chart::light, Rational(10, 3), Rational(11, 3), zigzag(Axis::ratio, 400)));
}

TEST_CASE("a removed leaf is missing area") {
    for (const std::size_t victim : {0U, 77U, 199U}) {
        Boxes boxes = random_boxes(3);
        const auto ends = boxes.leaves[victim];
        Rational volume = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            volume *= boxes.hi(ends, axis) - boxes.lo(ends, axis);
        }
        boxes.leaves.erase(boxes.leaves.begin() + static_cast<std::ptrdiff_t>(victim));
        const Tiling tiling = check_tiling(boxes);
        CHECK(tiling.fault == Fault::missing_area);
        CHECK(tiling.missing == volume);
    }
}

TEST_CASE("a leaf of area 2^-400 of the root is missed") {
    Boxes boxes = leaf_boxes(Chart::bridge, 10, 10, zigzag(Axis::position, 400));
    const auto smallest = std::find_if(boxes.leaves.begin(), boxes.leaves.end(), [&](const auto& ends) {
        return (boxes.hi(ends, 0) - boxes.lo(ends, 0)) * Rational(Integer(1) << 399) == 1;
    });
    REQUIRE(smallest != boxes.leaves.end());
    boxes.leaves.erase(smallest);
    const Tiling tiling = check_tiling(boxes);
    CHECK(tiling.fault == Fault::missing_area);
    CHECK(tiling.missing == Rational(16) / Rational(Integer(1) << 399));
}

TEST_CASE("no leaf at all is missing area") {
    const Tiling tiling = check_tiling(root_of(Chart::bridge, 10, 10));
    CHECK(tiling.fault == Fault::missing_area);
    CHECK(tiling.missing == 32);
}

TEST_CASE("a duplicated leaf overlaps its twin") {
    Boxes boxes = random_boxes(4);
    boxes.leaves.push_back(boxes.leaves[42]);
    const Tiling tiling = check_tiling(boxes);
    CHECK(tiling.fault == Fault::overlap);
    CHECK(tiling.first == 42);
    CHECK(tiling.second == 200);
}

TEST_CASE("a leaf in another's place is found though the number of leaves is right") {
    Boxes boxes = random_boxes(5);
    boxes.leaves[11] = boxes.leaves[150];
    const Tiling tiling = check_tiling(boxes);
    CHECK(tiling.fault == Fault::overlap);
    CHECK(tiling.first == 11);
    CHECK(tiling.second == 150);
}

TEST_CASE("an overlap far below a double's resolution is found, although the total area is right") {
    // [0, 1/3 + d] and [1/3, 2 - d] ... the halves overlap by d and the last leaves d out.
    const Rational d = Rational(1) / Rational(Integer(1) << 400);
    const Rational third(1, 3);
    const auto strip = [](Boxes& boxes, const Rational& from, const Rational& to) {
        boxes.leaves.push_back(boxes.box({from, 0, 10}, {to, 16, 10}));
    };
    Boxes exact = root_of(Chart::bridge, 10, 10);
    strip(exact, 0, third);
    strip(exact, third, 2);
    CHECK_FALSE(check_tiling(exact).fault);

    Boxes wrong = root_of(Chart::bridge, 10, 10);
    strip(wrong, 0, third + d);
    strip(wrong, third, 2 - d);
    const Tiling overlap = check_tiling(wrong);
    CHECK(overlap.fault == Fault::overlap);
    CHECK(overlap.pairs == 1);

    Boxes hole = root_of(Chart::bridge, 10, 10);
    strip(hole, 0, third);
    strip(hole, third + d, 2);
    const Tiling missing = check_tiling(hole);
    CHECK(missing.fault == Fault::missing_area);
    CHECK(missing.missing == 16 * d);
}

TEST_CASE("boxes inside one another overlap") {
    Boxes boxes = leaf_boxes(Chart::bridge, 10, 13, {leaf()});
    boxes.leaves.push_back(boxes.box({1, 1, 11}, {Rational(3, 2), 2, 12}));
    CHECK(check_tiling(boxes).fault == Fault::overlap);
}

TEST_CASE("a box beyond the root sticks out") {
    const Rational d = Rational(1) / Rational(Integer(1) << 400);
    Boxes boxes = root_of(Chart::bridge, 10, 10);
    boxes.leaves.push_back(boxes.box({0, 0, 10}, {2, 16 + d, 10}));
    CHECK(check_tiling(boxes).fault == Fault::sticks_out);
    boxes.leaves[0] = boxes.box({0, 0, 10}, {2, 16, 11});
    CHECK(check_tiling(boxes).fault == Fault::sticks_out);
    boxes.leaves[0] = boxes.box({-d, 0, 10}, {2, 16, 10});
    CHECK(check_tiling(boxes).fault == Fault::sticks_out);
}

TEST_CASE("a reversed box is refused") {
    Boxes boxes = root_of(Chart::bridge, 10, 10);
    boxes.leaves.push_back(boxes.box({2, 0, 10}, {0, 16, 10}));
    CHECK(check_tiling(boxes).fault == Fault::reversed);
}

TEST_CASE("tilings that no tree makes are tilings too") {
    // The pinwheel: no line cuts the square along the edges of the boxes.
    Boxes boxes;
    boxes.root = boxes.box({0, 0, 1}, {3, 3, 1});
    boxes.leaves = {boxes.box({0, 0, 1}, {2, 1, 1}), boxes.box({2, 0, 1}, {3, 2, 1}),
                    boxes.box({1, 2, 1}, {3, 3, 1}), boxes.box({0, 1, 1}, {1, 3, 1}),
                    boxes.box({1, 1, 1}, {2, 2, 1})};
    check_tiles(boxes);
}

TEST_CASE("boxes without an interior overlap nothing") {
    for (const bool first : {false, true}) {
        Boxes boxes = root_of(Chart::bridge, 10, 10);
        boxes.leaves = {boxes.root, boxes.box({1, 0, 10}, {1, 16, 10})};
        if (first) {
            std::swap(boxes.leaves[0], boxes.leaves[1]);
        }
        check_tiles(boxes);
    }
}

TEST_CASE("only boxes that touch are compared") {
    Boxes boxes = root_of(Chart::bridge, 10, 10);
    for (const int i : {0, 1, 2, 3}) {
        boxes.leaves.push_back(boxes.box({Rational(i, 2), 0, 10}, {Rational(i + 1, 2), 16, 10}));
    }
    check_tiles(boxes);
    CHECK(check_tiling(boxes).pairs == 3);
}
