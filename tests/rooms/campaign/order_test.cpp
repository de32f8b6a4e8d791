#include "campaign/order.hpp"

#include <catch2/catch.hpp>

#include "base/error.hpp"
#include "resealed.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using Catch::Matchers::Contains;
using dumbbell_test::resealed;

namespace {

const Order two_pieces{"prove collisions\nscene dumbbell\n", {"piece 1/1 2/1 3 2", "piece 2/1 3/1 3 3"}};

}  // namespace

TEST_CASE("an order is read back as it was written") {
    CHECK(parse_order(two_pieces.text()) == two_pieces);
    CHECK(two_pieces.kind() == "collisions");
    CHECK(two_pieces.id().size() == 32);
}

TEST_CASE("orders that differ in anything have different names") {
    Order other = two_pieces;
    other.units.pop_back();
    CHECK(other.id() != two_pieces.id());
    other = two_pieces;
    other.head = "prove collisions\nscene hybrid\n";
    CHECK(other.id() != two_pieces.id());
    CHECK(Order(two_pieces).id() == two_pieces.id());
}

TEST_CASE("an order that lost or gained a byte anywhere is refused") {
    const std::string text = two_pieces.text();
    for (std::size_t i = 0; i < text.size(); ++i) {
        CHECK_THROWS_AS(parse_order(text.substr(0, i)), InputError);
        std::string changed = text;
        changed[i] ^= 1;
        CHECK_THROWS_AS(parse_order(changed), InputError);
    }
    CHECK_THROWS_AS(parse_order(text + "\n"), InputError);
}

TEST_CASE("an order of another version is refused, with what to do") {
    const std::string other =
        resealed(two_pieces.text(), "generator dumbbell " DUMBBELL_VERSION, "generator dumbbell 9.9");
    CHECK_THROWS_WITH(parse_order(other),
                      Contains("dumbbell 9.9") && Contains("install the manager's version"));
}

TEST_CASE("an order with a right checksum under something else is refused") {
    CHECK_THROWS_AS(parse_order(resealed(two_pieces.text(), "units 2", "units 3")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(two_pieces.text(), "units 2", "units 1")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(two_pieces.text(), "units 2", "units 99999999999999999999")),
                    InputError);
    CHECK_THROWS_AS(parse_order(resealed(two_pieces.text(), "prove collisions\n", "")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(two_pieces.text(), "dumbbell-order 1", "dumbbell-order 2")),
                    InputError);
}
