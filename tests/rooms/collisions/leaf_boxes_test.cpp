#include "collisions/leaf_boxes.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/section.hpp"
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
    CHECK(boxes.lo(ends, 0) == Rational(box.e_lo));
    CHECK(boxes.hi(ends, 0) == Rational(box.e_hi));
    CHECK(boxes.lo(ends, 1) == Rational(box.slope_lo));
    CHECK(boxes.hi(ends, 1) == Rational(box.slope_hi));
    CHECK(boxes.lo(ends, 2) == Rational(box.q_lo));
    CHECK(boxes.hi(ends, 2) == Rational(box.q_hi));
    CHECK(boxes.lo(ends, 3) == Rational(box.rho_lo));
    CHECK(boxes.hi(ends, 3) == Rational(box.rho_hi));
}

/// Are the leaf boxes of a random tree the prover's?
void check_leaves(Chart chart, const std::vector<Axis>& axes, const std::optional<Heights>& heights) {
    const Tree tree = random_tree(60, axes, 5);
    const Boxes boxes = leaf_boxes(chart, Rational(10, 3), Rational(31, 7), tree, heights);
    Box root = root_box(chart, Rational(10, 3), Rational(31, 7));
    if (heights) {
        root.rho_lo = heights->lo;
        root.rho_hi = heights->hi;
    }
    std::vector<Box> expected;
    std::size_t next = 0;
    prover_boxes(tree, next, root, expected);
    REQUIRE(boxes.leaves.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        check_same(boxes, boxes.leaves[i], expected[i]);
    }
}

constexpr auto root_charts = {Chart::bridge,        Chart::light,           Chart::contact, Chart::departure,
                              Chart::plain_contact, Chart::plain_departure, Chart::wedge};

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
        check_leaves(chart, chart == Chart::wedge ? wedge_axes : all_axes, {});
    }
    for (const Chart chart : {Chart::plain_contact, Chart::plain_departure}) {
        check_leaves(chart, body_axes, Heights{Rational(3, 10), Rational(5, 7)});
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

TEST_CASE("the chart wedge has no position, and only bodies have a rho") {
    CHECK_THROWS_AS(leaf_boxes(Chart::plain_contact, 2, 2, {split(Axis::rho), leaf(), leaf()}), InputError);
    CHECK_THROWS_AS(leaf_boxes(Chart::wedge, 2, 2, {split(Axis::position), leaf(), leaf()}), InputError);
}
