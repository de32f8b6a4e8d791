// The greatest ratio that is tried.
#include <catch2/catch.hpp>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

TEST_CASE("the maximum at 10^100 is proved, verified, and what the law says") {
    const TemporaryFolder folder;
    const std::string file = folder / "farthest.dbc";
    const Json law = Json::parse(dumbbell({"law", "--ratio", "1e100", "--json"}).out);
    const std::string maximum = law.at("upper");
    REQUIRE(law.at("lower") == maximum);
    REQUIRE(maximum.size() == 50);
    std::string more = maximum, less = maximum;
    REQUIRE((maximum.back() > '0' && maximum.back() < '9'));
    ++more.back();
    --less.back();

    const Outcome made = dumbbell({"certify", "1e100", "--json", "--out", file});
    REQUIRE(made.code == 0);
    const Json piece = Json::parse(made.out).at("pieces").at(0);
    CHECK(piece.at("upper") == maximum);
    CHECK(piece.at("lower") == maximum);
    const auto verified = [&](const std::string& claim) {
        return verifier({"--quiet", "--ratio", "1e100", "--exactly", claim, file});
    };
    CHECK(verified(maximum).code == 0);
    for (const std::string& claim : {more, less}) {
        const Outcome refused = verified(claim);
        CHECK(refused.code == 1);
        CHECK_THAT(refused.out, Contains("code=claim-not-proved"));
    }
}

TEST_CASE("certify stops soon at 10^100") {
    const TemporaryFolder folder;
    const Outcome late =
        dumbbell({"certify", "1e100", "--budget", "1s", "--json", "--out", folder / "late.dbc"});
    CHECK(late.code == 3);
    CHECK_THAT(late.err, Contains("not decided: allow more time"));
    CHECK(Json::parse(late.out).at("seconds") < 10);
}
