// dumbbell adiabatic: what it says, its exit codes, and that the verifier takes what it writes.
#include "catch.hpp"
#include "programs.hpp"
#include "scale.hpp"

using namespace dumbbell_test;

namespace {

Words adiabatic(Words options) {
    options.insert(options.begin(), "adiabatic");
    return options;
}

/// Certifies, writes and verifies the statement.
void check_written(const TemporaryFolder& folder, Words options) {
    options.insert(options.end(), {"--out", "claim.dbc"});
    const Outcome result = dumbbell(adiabatic(options), folder.path());
    CAPTURE(options, result.out, result.err);
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    const std::string check = "Check it:    dumbbell verify";
    REQUIRE_THAT(result.out, Contains(check));
    const Outcome verified =
        run({"sh", "-c", DUMBBELL_VERIFY_BIN + result.out.substr(result.out.find(check) + check.size())},
            folder.path());
    CAPTURE(verified.out);
    CHECK(verified.code == 0);
    CHECK_THAT(verified.out, Contains("s VERIFIED claim=adiabatic-") && Contains(" demanded-attained="));
    CHECK_THAT(verified.out, !Contains("not-demanded="));
}

}  // namespace

// Where the masses differ least, the enclosures of the two programs differ most.
TEST_CASE("adiabatic writes certificates that the verifier takes, at any delta below 1/2", "[wings]") {
    const TemporaryFolder folder;
    const std::vector<const char*> deltas{"0.01", "1/6",  "0.49", "0.1:0.45", "0.001", "0.1",
                                          "0.11", "0.12", "0.13", "1/7",      "0.2",   "0.25",
                                          "0.3",  "0.32", "1/3",  "0.4",      "0.45",  "0.2:0.3"};
    for (const char* delta : some_of(deltas, 4)) {
        check_written(folder, {"--theorem", "lemma3.1", "--delta", delta});
    }
    for (const char* margin : some_of(std::vector<const char*>{"0.3", "0.5", "1"}, 1)) {
        for (const char* k : {"0", "1/4", "1"}) {
            check_written(folder,
                          {"--theorem", "cor3.2", "--delta", "0.3", "--phi-margin", margin, "--k", k});
        }
        check_written(folder,
                      {"--theorem", "lemma3.1", "--delta", "0.2", "--phi-margin", margin, "--y", "0.2:0.7"});
    }
    for (const Words& options :
         some_of(std::vector<Words>{{"--delta", "0.2", "--phi-margin", "0.9"},
                                    {"--delta", "0.1", "--theorem", "thm3.5", "--phi-margin", "1"},
                                    {"--delta", "0.01"},
                                    {"--delta", "0.002:0.003", "--phi-margin", "0.5", "--y", "0.3:0.8"},
                                    {"--delta", "0.01", "--theorem", "thm3.5"}},
                 1)) {
        check_written(folder, options);
    }
}

// docs/6-adiabatic.md: the first bounce is sqrt(delta)/2 from the vertical, and the last almost stops the
// rod.
TEST_CASE("Theorem 3.5 as printed is not true at delta = 0.01: an orbit, enclosed", "[wings]") {
    const Outcome result = dumbbell({"trace", "9999", "--phi", "3.66238893", "--phidot", "1", "--y",
                                     "1.0060771", "--ydot", "-0.0074267297", "--json"});
    REQUIRE(result.code == 0);
    const auto collisions = nlohmann::ordered_json::parse(result.out).at("collisions");
    REQUIRE(collisions.size() == 7);
    CHECK(collisions.front().at("phi").at(1) < 4.71238898 - 0.05);
    CHECK(collisions.front().at("phidot_before").at(0) == 1);
    CHECK(collisions.front().at("y").at(0) > 0.9986);  // so I_0 = pi - arccos y > 3.0886
    CHECK(collisions.back().at("phidot_after").at(0) > -0.0119);
    CHECK(collisions.back().at("phidot_after").at(1) < 0);
}

TEST_CASE("several distances give a table", "[wings]") {
    const Outcome result = dumbbell(adiabatic({"--delta", "0.2", "--phi-margin", "0.8,0.9"}));
    CHECK(result.code == 0);
    CHECK_THAT(result.out, Contains("distance") && Contains("\n     0.9  |I_n - I_0|"));
}

TEST_CASE("a distance in degrees or as a multiple of pi is the one in radians, cut down", "[wings]") {
    const auto printed = [](const std::string& margin) {
        const Outcome result = dumbbell(adiabatic({"--delta", "0.2", "--phi-margin", margin, "--quiet"}));
        CHECK(result.code == 0);
        return result.out;
    };
    CHECK(printed("54deg,0.25pi") == printed("0.942477796076,0.785398163397"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--phi-margin", "0.3:0.4"}), Contains("no range"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--phi-margin", "pi/"}), Contains("--phi-margin"));
}

TEST_CASE("hypotheses that make no sense are refused in one line, and nothing is written", "[wings]") {
    for (const char* delta : {"0", "0.5", "0.7", "-0.1", "x", "0.02:0.01", "0.1:0.5", ""}) {
        refused({"adiabatic", "--delta", delta, "--out", "file.dbc"});
    }
    for (const char* theorem : {"lemma3.1", "cor3.2", "thm3.3", "thm3.5"}) {
        for (const char* delta : {"1e-300", "0:1e-300", "1e-1000:0.01", "nan", "inf"}) {
            refused({"adiabatic", "--theorem", theorem, "--delta", delta, "--out", "file.dbc"});
        }
    }
    for (const char* option :
         {"--y", "--phi-margin", "--k", "--bounces", "--accuracy", "--budget", "--out"}) {
        const char* theorem = std::string(option) == "--k" ? "cor3.2" : "thm3.3";
        CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--theorem", theorem, option, ""}),
                   Contains(option));
    }
    for (const char* k : {"1e400", "1e-400", "-1", "nan", ""}) {
        refused({"adiabatic", "--delta", "0.01", "--theorem", "cor3.2", "--k", k, "--out", "file.dbc"});
    }
    CHECK_THAT(refused({"adiabatic", "--delta", "0.5"}), Contains("between 0 and 1/2"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.02:0.01"}), Contains("reversed"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--y", "0.5:2"}), Contains("within 0:1"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--k", "1/2"}), Contains("cor3.2 only"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--theorem", "cor3.2", "--k", "1/3"}),
               Contains("multiple of 1/16"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--theorem", "thm3.5", "--y", "0:1"}),
               Contains("--y is for"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--theorem", "thm3.5", "--bounces", "1"}),
               Contains("thm3.3 only"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--bounces", "0"}), Contains("greater than 0"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--accuracy", "0"}), Contains("--accuracy"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--budget", "5"}), Contains("30s"));
    CHECK_THAT(refused({"adiabatic", "--delta", "0.01", "--phi-margin", "0.3,0.5", "--out", "file.dbc"}),
               Contains("one statement"));
    refused({"adiabatic"});
    refused({"adiabatic", "--delta", "0.01", "--theorem", "thm3.4"});
}

TEST_CASE("a budget that is used up certifies nothing, says so, and writes nothing", "[wings]") {
    const TemporaryFolder folder;
    const Outcome result =
        dumbbell(adiabatic({"--delta", "0.01", "--budget", "0s", "--out", "none.dbc"}), folder.path());
    CHECK(result.code == 3);
    CHECK_THAT(result.err, Contains("not certified: the budget is used up; no certificate is written"));
    CHECK_THAT(result.out, Contains("no bound was certified") && !Contains("<= 1"));
    CHECK(folder.names().empty());
}

TEST_CASE("the attained orbit has at most K/delta bounces", "[wings]") {
    const Outcome result = dumbbell(adiabatic({"--delta", "0.01", "--bounces", "1/10", "--json"}));
    REQUIRE(result.code == 0);
    const auto json = nlohmann::ordered_json::parse(result.out);
    CHECK(json.at("results").at(0).at("errors").at(0).at("attained").at("n") <= 10);
}
