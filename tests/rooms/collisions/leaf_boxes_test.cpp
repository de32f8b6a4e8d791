#include "collisions/leaf_boxes.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/chart.hpp"
#include "random_tree.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;

namespace {

/// The leaf boxes that the prover's own functions give.
void prover_boxes(const Tree& tree, std::size_t& next, const Box& box, std::vector<Box>& found) {
    const Node& node = tree[next++];
    if (!node.split) {
        found.push_back(box);
        return;
    }
    const auto [lower, upper] = halves(box, *node.split);
    prover_boxes(tree, next, lower, found);
    prover_boxes(tree, next, upper, found);
}

void check_same(const Boxes& boxes, const BoxEnds& ends, const Box& box) {
    for (const Axis axis : all_axes) {
        const auto number = static_cast<std::size_t>(axis);
        CHECK(boxes.lo(ends, number) == Rational(box[axis].lo));
        CHECK(boxes.hi(ends, number) == Rational(box[axis].hi));
    }
}

/// Are the leaf boxes of a random tree the prover's?
void check_leaves(Chart chart, const std::vector<Axis>& axes) {
    const Tree tree = random_tree(60, axes, 5);
    const Boxes boxes = leaf_boxes(chart, Rational(10, 3), Rational(31, 7), tree);
    const Box root = root_box(chart, Rational(10, 3), Rational(31, 7));
    std::vector<Box> expected;
    std::size_t next = 0;
    prover_boxes(tree, next, root, expected);
    REQUIRE(boxes.leaves.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        check_same(boxes, boxes.leaves[i], expected[i]);
    }
}

constexpr auto root_charts = {Chart::bridge,    Chart::light,         Chart::contact,
                              Chart::departure, Chart::plain_contact, Chart::plain_departure};

}  // namespace

TEST_CASE("the root boxes are the prover's") {
    for (const Chart chart : root_charts) {
        for (const Rational& q : {Rational(1), Rational(3, 2), Rational(4), Rational(1000003, 7)}) {
            const Boxes boxes = root_of(chart, q, q + 1);
            check_same(boxes, boxes.root, root_box(chart, q, q + 1));
            const Boxes single = root_of(chart, q, q);
            check_same(single, single.root, root_box(chart, q, q));
        }
    }
}

TEST_CASE("the leaf boxes are the prover's") {
    for (const Chart chart : root_charts) {
        check_leaves(chart, three_axes);
    }
}

TEST_CASE("a tree with nodes after its end is refused") {
    CHECK_THROWS_AS(leaf_boxes(Chart::bridge, 2, 2, {leaf(), leaf()}), InputError);
}

TEST_CASE("an axis is split at most 400 times above a node, however many leaves the tree has") {
    const auto comb = [](int splits, Axis axis) {
        Tree tree(static_cast<std::size_t>(splits), split(axis));
        tree.resize(static_cast<std::size_t>(2 * splits + 1), leaf());
        return tree;
    };
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio}) {
        CHECK(leaf_boxes(Chart::bridge, 2, 3, comb(400, axis)).leaves.size() == 401);
        CHECK_THROWS_AS(leaf_boxes(Chart::bridge, 2, 3, comb(401, axis)), InputError);
        CHECK_THROWS_AS(leaf_boxes(Chart::bridge, 2, 3, comb(100000, axis)), InputError);
    }
}
