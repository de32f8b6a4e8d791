#include "starts/cover/packed_tree.hpp"

#include "catch.hpp"
#include "rooms/wings/starts/sample.hpp"

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

TEST_CASE("the boxes of a generation follow from the splits above it, while its nodes are added") {
    PackedTree tree;
    std::vector<Place> places;
    const auto add = [&](std::size_t generation, const std::vector<Node>& nodes) {
        places.clear();
        tree.for_each_place(generation, [&](const Place& place) {
            tree.add(generation, nodes.at(places.size()));
            places.push_back(place);
        });
        CHECK(places.size() == nodes.size());
    };
    add(0, {initial_split(Axis::phi)});
    add(1, {initial_split(Axis::y), initial_split(Axis::phi)});
    add(2, {exactly(1), initial_split(Axis::y), open_leaf(), exactly(2)});
    add(3, {exactly(3), exactly(4)});
    const Box root{{Rational(0), Rational(-1), Rational(1), Rational(-1), Rational(10)},
                   {Rational(2), Rational(-1), Rational(5), Rational(-1), Rational(10)}};
    for (const Place& place : places) {
        const Box box = place.in(root);
        CHECK(box.lower(Axis::phi) == 0);
        CHECK(box.upper(Axis::phi) == 1);
        CHECK(box.lower(Axis::y) == (&place == &places[0] ? 3 : 4));
        CHECK(box.upper(Axis::y) == (&place == &places[0] ? 4 : 5));
        CHECK(box.lower(Axis::phidot) == -1);
    }
    add(4, {});
    CHECK(tree.nodes().size() == 9);
}
