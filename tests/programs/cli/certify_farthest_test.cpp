// The greatest ratio that is tried.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Json = nlohmann::json;

TEST_CASE("the maximum at 10^100 is proved, verified, and what the law says") {
    const TemporaryFolder folder;
    const std::string file = folder / "farthest.dbc";
    const Json law = Json::parse(dumbbell({"law", "--ratio", "1e100", "--json"}).out);
    const std::string upper = law.at("upper");
    REQUIRE(law.at("lower") == upper);
    REQUIRE(upper.size() == 50);
    const Outcome made = dumbbell({"certify", "1e100", "--json", "--out", file});
    REQUIRE(made.code == 0);
    const Json piece = Json::parse(made.out).at("pieces").at(0);
    CHECK(piece.at("upper") == upper);
    CHECK(piece.at("lower") == upper);
    CHECK(verifier({"--quiet", "--ratio", "1e100", "--exactly", upper, file}).code == 0);
}
