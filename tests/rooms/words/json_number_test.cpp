#include "words/json_number.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace dumbbell;

TEST_CASE("zero is printed without a sign, every other number as it is") {
    CHECK_FALSE(std::signbit(unsigned_zero(-0.0)));
    for (const double x : {1.0, -1.0, -0x1p-1074, 1e300}) {
        CHECK(unsigned_zero(x) == x);
    }
    CHECK(ends_json(Interval(-0.0, 0.5)).dump() == "[0.0,0.5]");
    CHECK(ends_json(Interval(-0.5, -0.0)).dump() == "[-0.5,0.0]");
}

TEST_CASE("what is not known is null") {
    CHECK(json_or_null(std::optional<long>(3)) == 3);
    CHECK(json_or_null(std::optional<long>()).is_null());
}
