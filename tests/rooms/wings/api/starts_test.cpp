#include "dumbbell/starts.hpp"

#include "catch.hpp"
#include "dumbbell/error.hpp"
#include "dumbbell/picture.hpp"
#include "dumbbell/verify.hpp"

using namespace dumbbell::api;

namespace {
const InitialCondition falling_box{.phi = "0:3", .phidot = "0", .y = "2", .ydot = "-2:-1"};
}

TEST_CASE("A box of starts is proved, and the verifier agrees") {
    const StartsProof proof = certify_starts(MassRatio("10"), falling_box, {.boxes = 300});
    REQUIRE(proof.most);
    CHECK(proof.least <= *proof.most);
    CHECK(!proof.shares.empty());
    CHECK_THAT(proof.demand, Contains("--phi 0:3 --phidot 0 --y 2 --ydot -2:-1 --ratio 10 "));
    CHECK(verify_text(proof.certificate, {.demand = proof.demand}).sha256 == proof.sha256);
    CHECK(certify_starts(MassRatio("10"), falling_box, {.boxes = 300, .jobs = 2}).certificate ==
          proof.certificate);
    CHECK(picture(proof).starts_with("<svg"));
}

TEST_CASE("All incoming trajectories: the mean of the boxes has that of theorem 6 between its bounds") {
    const StartsProof proof = certify_incoming(MassRatio("3"), {.boxes = 300});
    CHECK(verify_text(proof.certificate, {.demand = proof.demand}));
    const auto number = [](const std::string& fraction) {
        const auto slash = fraction.find('/');
        return std::stod(fraction.substr(0, slash)) / std::stod(fraction.substr(slash + 1));
    };
    const Interval mean = mean_collisions(MassRatio("3"));
    CHECK(number(proof.mean_lo) < mean.lo);
    CHECK((proof.mean_hi && mean.hi < number(*proof.mean_hi)));
    CHECK_THROWS_AS(certify_incoming(MassRatio("2:3")), InputError);
    CHECK_THROWS_AS(mean_collisions(MassRatio("2:3")), InputError);
}

TEST_CASE("Stopped, a box is bounded by what is decided") {
    const StartsProof proof = certify_starts(MassRatio("10"), falling_box, {.stopped = [] { return true; }});
    CHECK(verify_text(proof.certificate, {.ratio = "10", .kind = "initial-conditions"}).verdict !=
          Verdict::rejected);
    CHECK_THROWS_AS(certify_starts(MassRatio("10"), falling_box, {.boxes = 0}), InputError);
    CHECK_THROWS_AS(certify_starts(MassRatio("10"), {"x", "0", "2", "-1"}), InputError);
}
