#include "dumbbell/mass_ratio.hpp"

#include "catch.hpp"
#include "dumbbell/error.hpp"

using namespace dumbbell::api;

TEST_CASE("A mass ratio is exactly what is written, below 1 with the masses swapped") {
    CHECK(MassRatio("10").lo() == "10/1");
    CHECK(MassRatio("10").hi() == "10/1");
    CHECK(MassRatio("4.6").lo() == "23/5");
    CHECK(MassRatio("6/4").hi() == "3/2");
    CHECK(MassRatio("0.1").lo() == "10/1");
    CHECK(MassRatio("1:1e2").lo() == "1/1");
    CHECK(MassRatio("1:1e2").hi() == "100/1");
    CHECK(MassRatio("1/4:1/2").lo() == "2/1");
    CHECK(MassRatio("1/4:1/2").hi() == "4/1");
}

TEST_CASE("What is no mass ratio is refused in one line") {
    for (const char* text :
         {"", "0", "ten", "-3", "2:", "3:2", "1/2:2", "1/0", "1e1001", " 1", "nan", "1:2:3"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(MassRatio(text), InputError);
    }
    CHECK_THROWS_WITH(MassRatio("3:2"), "the range '3:2' is reversed: write the smaller ratio first");
}
