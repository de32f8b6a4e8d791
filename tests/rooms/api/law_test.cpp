#include "dumbbell/law.hpp"

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/error.hpp"

using namespace dumbbell::api;

TEST_CASE("The law agrees with what is proved, and reaches further") {
    for (const char* q : {"1", "4.6", "10", "1000", "1e6"}) {
        const Law found = law(MassRatio(q));
        const Proof proof = certify(MassRatio(q));
        CHECK(std::stol(found.least) <= proof.least());
        CHECK(std::stol(found.most) >= *proof.most());
    }
    const Law far = law(MassRatio("1e24"));
    CHECK(far.least == "885595129454");
    CHECK(far.most == far.least);
    CHECK((far.past.lo <= far.past.hi && far.past.hi <= 1));
}

TEST_CASE("The law takes one ratio") { CHECK_THROWS_AS(law(MassRatio("2:3")), InputError); }
