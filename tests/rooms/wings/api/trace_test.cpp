#include "dumbbell/trace.hpp"

#include "catch.hpp"
#include "dumbbell/error.hpp"

using namespace dumbbell::api;

namespace {
const InitialCondition falling{.phi = "1/3", .phidot = "1", .y = "3", .ydot = "-1/2"};
}

TEST_CASE("One orbit is followed to its end") {
    const Trace orbit = trace(MassRatio("10"), falling);
    REQUIRE(orbit.most);
    CHECK(orbit.least == *orbit.most);
    REQUIRE(orbit.collisions.size() == static_cast<std::size_t>(orbit.least));
    for (const Collision& c : orbit.collisions) {
        CHECK((c.time.lo > 0 && c.time.hi - c.time.lo < 1e-9));
        CHECK((c.grazing_sine.lo > 0 && c.grazing_sine.hi <= 1.001));
        CHECK(c.ydot_after.lo > c.ydot_before.hi);  // L2 (a)
    }
}

TEST_CASE("A box has bounds, and more digits decide more") {
    InitialCondition box = falling;
    box.phi = "0:3";
    const Trace all = trace(MassRatio("10"), box);
    const Trace one = trace(MassRatio("10"), falling);
    CHECK(all.least <= one.least);
    CHECK((!all.most || *all.most >= one.least));
    const Trace sharp = trace(MassRatio("10"), falling, 30);
    CHECK(sharp.least == one.least);
    CHECK(sharp.collisions.size() == one.collisions.size());
    CHECK(sharp.collisions[0].time.lo >= one.collisions[0].time.lo);
    CHECK(sharp.collisions[0].time.hi <= one.collisions[0].time.hi);
}

TEST_CASE("What cannot be traced is refused, by name") {
    const auto refused = [](InitialCondition start, const char* what) {
        CHECK_THROWS_WITH(trace(MassRatio("10"), start), Contains(what));
        CHECK_THROWS_AS(trace(MassRatio("10"), start), InputError);
    };
    InitialCondition start = falling;
    start.y = "high";
    refused(start, "y");
    start = falling;
    start.y = "0";
    refused(start, "floor");
    start = falling;
    start.phi = "2:1";
    refused(start, "phi");
    CHECK_THROWS_AS(trace(MassRatio("10"), falling, -1), InputError);
    CHECK_THROWS_AS(trace(MassRatio("10"), falling, 100'001), InputError);
}
