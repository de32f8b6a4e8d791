#include "starts/packed_tree.hpp"

#include "catch.hpp"
#include "sample.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using namespace dumbbell_test;

TEST_CASE("a tree that is packed generation by generation is unpacked in pre-order, exactly") {
    const Rational fine = Rational(5) / Rational(Integer(1) << 3000U);
    const Rational large(Integer(3) << 300U);
    PackedTree tree;
    tree.add(0, initial_split(Axis::ratio));
    tree.add(1, initial_split(Axis::phi));
    tree.add(1, between(1, 17));
    tree.add(2, {{}, {2, 2, FirstContact{true, fine, large}}});
    tree.add(2, {{}, {1, std::nullopt, FirstContact{false, Rational(3, 4), 7}}});
    CHECK(tree.size() == 5);
    const auto nodes = tree.nodes();
    REQUIRE(nodes.size() == 5);
    CHECK(nodes[0].split == Axis::ratio);
    CHECK(nodes[1].split == Axis::phi);
    REQUIRE(nodes[2].leaf.first.has_value());
    CHECK(nodes[2].leaf.most == 2);
    CHECK(nodes[2].leaf.first->heavy);
    CHECK(nodes[2].leaf.first->from == fine);
    CHECK(nodes[2].leaf.first->until == large);
    CHECK_FALSE(nodes[3].split.has_value());
    CHECK(nodes[3].leaf.least == 1);
    CHECK_FALSE(nodes[3].leaf.most.has_value());
    CHECK_FALSE(nodes[3].leaf.first->heavy);
    CHECK(nodes[3].leaf.first->from == Rational(3, 4));
    CHECK(nodes[3].leaf.first->until == 7);
    CHECK_FALSE(nodes[4].leaf.first.has_value());
    CHECK(nodes[4].leaf.most == 17);
}

TEST_CASE("a packed tree that is not complete is not unpacked") {
    PackedTree tree;
    CHECK_THROWS(tree.nodes());
    tree.add(0, initial_split(Axis::y));
    CHECK_THROWS(tree.nodes());
    tree.add(1, exactly(3));
    CHECK_THROWS(tree.nodes());
    tree.add(1, open_leaf());
    CHECK(tree.nodes().size() == 3);
}
