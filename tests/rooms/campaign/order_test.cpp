#include "campaign/order.hpp"

#include <catch2/catch.hpp>

#include "base/error.hpp"
#include "resealed.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using Catch::Matchers::Contains;
using dumbbell_test::resealed;

namespace {

const Order order{"prove collisions\nscene dumbbell\n", {"piece 1/1 2/1 3 2", "piece 2/1 3/1 3 3"}};

}  // namespace

TEST_CASE("an order is read back as it was written") {
    CHECK(parse_order(order.text()) == order);
    CHECK(order.kind() == "collisions");
    CHECK(order.id().size() == 32);
}

TEST_CASE("orders that differ in anything have different names") {
    Order other = order;
    other.units.pop_back();
    CHECK(other.id() != order.id());
    other = order;
    other.head = "prove collisions\nscene hybrid\n";
    CHECK(other.id() != order.id());
    CHECK(Order(order).id() == order.id());
}

TEST_CASE("an order that lost or gained a byte anywhere is refused") {
    const std::string text = order.text();
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
        resealed(order.text(), "generator dumbbell " DUMBBELL_VERSION, "generator dumbbell 9.9");
    CHECK_THROWS_WITH(parse_order(other),
                      Contains("dumbbell 9.9") && Contains("install the manager's version"));
}

TEST_CASE("an order with a right checksum under something else is refused") {
    CHECK_THROWS_AS(parse_order(resealed(order.text(), "units 2", "units 3")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(order.text(), "units 2", "units 1")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(order.text(), "units 2", "units 99999999999999999999")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(order.text(), "prove collisions\n", "")), InputError);
    CHECK_THROWS_AS(parse_order(resealed(order.text(), "dumbbell-order 1", "dumbbell-order 2")), InputError);
}
