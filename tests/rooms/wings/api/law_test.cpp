#include "dumbbell/law.hpp"

#include "catch.hpp"

using namespace dumbbell::api;

TEST_CASE("The law says where a ratio lies between two steps") {
    const Law far = law(MassRatio("1e24"));
    CHECK(far.step == "885595129455");
    CHECK((far.past.lo <= far.past.hi && far.past.hi <= 1));
}
