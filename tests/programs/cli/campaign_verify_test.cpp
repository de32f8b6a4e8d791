// The verification of a certificate as a campaign: plan ... verify FILE, run, merge, dumbbell-verify
// --combine.
#include <catch2/catch.hpp>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
namespace fs = std::filesystem;

namespace {

/// A campaign `c` in the folder that verifies the file.
void planned(const TemporaryFolder& folder, const std::string& file, const Words& options = {}) {
    Words words{"campaign", "plan", folder / "c"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"verify", file});
    const Outcome plan = dumbbell(words);
    CAPTURE(plan.err);
    REQUIRE(plan.code == 0);
}

Outcome run_campaign(const TemporaryFolder& folder) { return dumbbell({"campaign", "run", folder / "c"}); }

Outcome merged(const TemporaryFolder& folder) {
    return dumbbell({"campaign", "merge", folder / "c", "--out", folder / "parts.txt"});
}

std::string verdict(const Words& words) { return last_line(verifier(words).out); }

}  // namespace

TEST_CASE("verified in shards, a certificate has the verdict that it has in one go") {
    for (const char* name : {"stairs-1-100.dbc", "stairs-1-1e4.dbc.gz"}) {
        const TemporaryFolder folder;
        const std::string file = std::string(DUMBBELL_PROJECT "/certificates/") + name;
        planned(folder, file, {"--shards", "9"});
        REQUIRE(run_campaign(folder).code == 0);
        REQUIRE(merged(folder).code == 0);
        const std::string parts = verdict({"--combine", folder / "parts.txt", file});
        const std::string whole = replaced(verdict({file}), "s VERIFIED ", "s COMBINED ");
        CHECK_THAT(parts, Catch::Matchers::StartsWith(whole + " parts="));
    }
}

TEST_CASE("a file with something after its certificate is not planned") {
    const TemporaryFolder folder;
    const std::string packed = contents(DUMBBELL_PROJECT "/certificates/stairs-1-1e4.dbc.gz");
    const std::string plain = contents(DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc");
    for (const std::string& bytes : {packed + "x\n", packed + packed, plain + "x\n"}) {
        write_file(folder / "bad.dbc", bytes);
        const Outcome refused = dumbbell({"campaign", "plan", folder / "c", "verify", folder / "bad.dbc"});
        CHECK(refused.code == 2);
        CHECK_THAT(refused.err, Contains("bad.dbc' is damaged: "));
    }
    CHECK(folder.names() == Words{"bad.dbc"});
}

TEST_CASE("of a wedge's certificate the parts combine, too") {
    const TemporaryFolder folder;
    const std::string file = DUMBBELL_PROJECT "/certificates/wedge-1-100.dbc";
    planned(folder, file);
    REQUIRE(run_campaign(folder).code == 0);
    REQUIRE(merged(folder).code == 0);
    CHECK_THAT(verdict({"--scene", "wedge", "--combine", folder / "parts.txt", file}),
               Contains("s COMBINED"));
}

TEST_CASE("a certificate with something false in it is not verified in shards either") {
    const TemporaryFolder folder;
    const std::string file = DUMBBELL_PROJECT "/tests/attacks/false_claims/across-gap.dbc";
    planned(folder, file, {"--shards", "100"});
    const Outcome ran = run_campaign(folder);
    CHECK(ran.code == 3);
    CHECK_THAT(ran.err, Contains("given up after 5 attempts") && Contains("REJECTED"));
    CHECK(merged(folder).code == 3);
    CHECK_FALSE(fs::exists(folder / "parts.txt"));
}

TEST_CASE("lines of another certificate, or of other pieces, are no results") {
    const TemporaryFolder folder;
    const std::string file = DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc";
    planned(folder, file, {"--shards", "3"});
    REQUIRE(run_campaign(folder).code == 0);
    const auto result = fs::directory_iterator(folder / "c/results")->path().string();
    const std::string truth = contents(result);
    const std::string other = last_line(
        verifier({"--quiet", "--shards", "1-2", DUMBBELL_PROJECT "/certificates/stairs-1-1e4.dbc.gz"}).out);
    for (const std::string& line : {other + "\n", truth + truth, truth.substr(0, truth.size() - 1),
                                    std::string(), "s VERIFIED\n" + truth}) {
        write_file(result, line);
        const Outcome refused = merged(folder);
        CAPTURE(line);
        CHECK(refused.code == 3);
        CHECK_THAT(refused.err, Contains("is not a verification of these pieces"));
        REQUIRE(run_campaign(folder).code == 0);
        CHECK(contents(result) == truth);
    }
    // Of the right form, but not what the verifier says: found when the parts are combined.
    write_file(result, replaced(truth, " gaps=", " gaps=1"));
    const Outcome refused = merged(folder);
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("the parts do not combine"));
    CHECK_FALSE(fs::exists(folder / "parts.txt"));
}

TEST_CASE("whose word a verification in shards is, is said") {
    const TemporaryFolder folder;
    planned(folder, DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc");
    REQUIRE(run_campaign(folder).code == 0);
    CHECK_THAT(merged(folder).out, Contains("shards as the workers' verifiers say; they tile the claim"));
}

TEST_CASE("a claim that the certificate does not prove is not said to be tiled") {
    const TemporaryFolder folder;
    planned(folder, DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc");
    write_sealed(folder / "c/plan",
                 replaced(contents(folder / "c/plan"), "over 1/1:100/1", "over 1/1:900/1"));
    REQUIRE(run_campaign(folder).code == 0);
    const Outcome refused = merged(folder);
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("do not tile the claim"));
    CHECK_FALSE(fs::exists(folder / "parts.txt"));
}

TEST_CASE("a small file of very many pieces is not unpacked into a plan") {
    const TemporaryFolder folder;
    const std::string text =
        "dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nlemmas 1\nscene dumbbell\n"
        "section turning\nclaim collisions\nratio 1/1 1/1\npieces 8000000\n";
    write_file(folder / "bomb.dbc", text);
    CHECK_THAT(refused({"campaign", "plan", folder / "c", "verify", folder / "bomb.dbc"}),
               Contains("8000000 pieces, more than 3000000"));
    CHECK(folder.names() == Words{"bomb.dbc"});
}

TEST_CASE("what is no certificate about collisions is not planned") {
    CHECK_THAT(refused({"campaign", "plan", "c", "verify", "none.dbc"}), Contains("none.dbc"));
    CHECK_THAT(refused({"campaign", "plan", "c", "verify", DUMBBELL_PROJECT "/README.md"}), EndsWith("\n"));
}
