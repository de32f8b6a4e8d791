// Exit 3: not everything was decided; what was is complete, written and verifiable.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

void check_open(const Outcome& result, const std::string& file) {
    CHECK(result.code == 3);
    CHECK(count_lines(result.err) == 1);
    const Outcome verdict = verifier({file});
    CAPTURE(verdict.out, verdict.err);
    const bool some = contents(file).find("\nupper none\n") == std::string::npos;
    CHECK(verdict.code == (some ? 0 : 3));
    CHECK_THAT(last_line(verdict.out), StartsWith(some ? "s VERIFIED " : "s OPEN "));
}

}  // namespace

TEST_CASE("without time a single ratio is open: exit 3, and the certificate says no more than it proves") {
    const TemporaryFolder folder;
    const Outcome result = dumbbell({"certify", "10", "--budget", "0s", "--out", "ten.dbc"}, folder.path());
    check_open(result, folder / "ten.dbc");
    CHECK_THAT(result.out, Contains("Not decided"));
    CHECK_THAT(contents(folder / "ten.dbc"), Contains("upper none\n") && Contains("total open 1\n"));
    CHECK(verifier({"--ratio", "10", "--max", "4", folder / "ten.dbc"}).code == 1);
    CHECK(verifier({"--ratio", "10", "--min", "1", folder / "ten.dbc"}).code == 1);
}

TEST_CASE("a budget ends a search that is in the middle of an orbit, of a cover, or in its plan") {
    for (const Words& words : {Words{"certify", "1e100"}, Words{"certify", "1e14", "--section", "full"},
                               Words{"certify", "9e10:1e11"}}) {
        CAPTURE(words);
        Words limited = words;
        limited.insert(limited.end(), {"--budget", "0.3s", "--jobs", "2"});
        const Outcome result = dumbbell(limited);
        CHECK(result.code == 3);
        CHECK(result.cpu_seconds < 8);
        CHECK_THAT(result.err, Contains("allow more time (--budget)"));
    }
}

TEST_CASE("what plain intervals cannot decide soon comes with advice") {
    const Outcome range = dumbbell({"certify", "4.5:4.6033", "--section", "plain", "--budget", "0.5s"});
    CHECK(range.code == 3);
    CHECK_THAT(range.err, Contains("boxes in inverse proportion to the gap: try --gap 0.01"));
    const Outcome single = dumbbell({"certify", "4.6033", "--section", "plain", "--budget", "0.5s"});
    CHECK(single.code == 3);
    CHECK_THAT(single.err, Contains("--section plain needs many boxes") && Contains("leave it out"));
}

TEST_CASE("a ratio that no certificate can decide is open with the reason") {
    // 1 + 10^-990: nearer to the critical ratio 1 than any precision that such a file may ask for.
    const Outcome result = dumbbell({"certify", "1." + std::string(989, '0') + "1", "--section", "full"});
    CHECK(result.code == 3);
    CHECK_THAT(result.err, Contains("not decided: 2048 bits do not tell it from a critical ratio"));
}

TEST_CASE("with --quiet, too, it is said on stderr why a ratio was not decided") {
    const Outcome result = dumbbell({"certify", "1e16", "--quiet", "--budget", "0s"});
    CHECK(result.code == 3);
    CHECK_THAT(result.out, StartsWith("Not decided: "));
    CHECK(count_lines(result.err) == 1);
}
