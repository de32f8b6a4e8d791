#include <catch2/catch.hpp>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;

TEST_CASE("law proves what a staircase says as a whole") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "1:1000", {"--gap", "1e-9"});
    const Outcome law = dumbbell({"law", stairs});
    CHECK(law.code == 0);
    CHECK(law.err.empty());
    CHECK_THAT(law.out, Contains("s VERIFIED") && Contains("N* goes from 2 to 29") &&
                            Contains("Proved:     N*(q) <= ceil(pi/gamma)") && !Contains("NOT proved") &&
                            Contains("85595129452713911412021948914557673005795294602"));
    const auto json = nlohmann::json::parse(dumbbell({"law", stairs, "--json", "--digits", "20"}).out);
    CHECK(json["schema"] == "dumbbell-law-1");
    CHECK(json["never_decreases"] == true);
    CHECK(json["below_paper_bound"] == true);
    CHECK(json["sup"]["hi"].get<double>() == Approx(2.1144048705).epsilon(1e-10));
}

TEST_CASE("law believes only what the verifier has accepted") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "2:12");
    std::string text = contents(stairs);
    text.replace(text.find("upper 4"), 7, "upper 3");
    write_file(stairs, text);
    const Outcome law = dumbbell({"law", stairs});
    CHECK(law.code == 2);
    CHECK(law.out.empty());
    CHECK(count_lines(law.err) == 1);
    CHECK_THAT(law.err, Contains("is not verified: s REJECTED"));
}

TEST_CASE("law needs a staircase of the dumbbell, without open pieces") {
    const TemporaryFolder folder;
    CHECK_THAT(dumbbell({"law", certificate(folder, "10")}).err, Contains("is no staircase"));
    CHECK(dumbbell({"law", certificate(folder, "2:4", {"--scene", "wedge"})}).code == 2);
    CHECK(dumbbell({"law", folder / "missing.dbc"}).code == 2);
    const std::string open = folder / "open.dbc";
    CHECK(dumbbell({"certify", "2:100000", "--budget", "0s", "--out", open}).code == 3);
    const Outcome law = dumbbell({"law", open});
    CHECK(law.code == 3);
    CHECK_THAT(law.out, Contains("NOT proved: pieces of this staircase are open"));
}
