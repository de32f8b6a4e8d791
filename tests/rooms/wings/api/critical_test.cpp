#include "dumbbell/critical.hpp"

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/error.hpp"

using namespace dumbbell::api;

TEST_CASE("A critical ratio is enclosed, and the maximum steps between its ends") {
    const auto four = critical(4, {.digits = 40});
    REQUIRE(four);
    CHECK(four->digits == "4.603338848751700352556582029103016513067");
    CHECK(four->lo.starts_with(four->digits));
    CHECK(certify(MassRatio(four->lo)).most() == 3);
    CHECK(certify(MassRatio(four->hi)).least() == 4);
}

TEST_CASE("A critical ratio that takes too long is none") {
    CHECK(!critical(1000, {.budget = std::chrono::seconds(0)}));
    CHECK(!critical(1000, {.stopped = [] { return true; }}));
    CHECK(critical(5, {.stopped = [] { return false; }}));
}

TEST_CASE("Where there is no critical ratio that is said") {
    for (const long n : {-1L, 2L, 100'000'000'000'000'001L}) {
        CHECK_THROWS_AS(critical(n), InputError);
    }
    for (const int digits : {0, 1001}) {
        CHECK_THROWS_AS(critical(4, {.digits = digits}), InputError);
    }
}
