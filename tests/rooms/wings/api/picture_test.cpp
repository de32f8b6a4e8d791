#include "dumbbell/picture.hpp"

#include "catch.hpp"
#include "dumbbell/error.hpp"

using namespace dumbbell::api;

TEST_CASE("A range has a staircase, a single ratio an orbit") {
    CHECK_THAT(picture(certify(MassRatio("1:20"))), StartsWith("<svg") && Contains("paper"));
    CHECK_THAT(picture(certify(MassRatio("100"))), StartsWith("<svg"));
}

TEST_CASE("What cannot be drawn is refused") {
    CHECK_THROWS_AS(picture(certify(MassRatio("10"), {.budget = std::chrono::seconds(0)})), InputError);
    CHECK_THROWS_AS(picture(certify(MassRatio("1e12"))), InputError);
    CHECK_THROWS_AS(picture(Proof{}), InputError);
}
