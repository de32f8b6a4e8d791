// From the prover to the independent verifier, through files.
#include "catch.hpp"
#include "programs.hpp"
#include "scale.hpp"

using namespace dumbbell_test;

namespace {

void check_verified(const Outcome& result) {
    CAPTURE(result.out, result.err);
    CHECK(result.code == 0);
    CHECK_THAT(last_line(result.out), StartsWith("s VERIFIED scene=dumbbell "));
}

void check_rejected(const Outcome& result) {
    CAPTURE(result.out, result.err);
    CHECK(result.code == 1);
    CHECK_THAT(last_line(result.out), StartsWith("s REJECTED "));
}

}  // namespace

TEST_CASE("the ratios of the promise: certified, verified, and exactly N proved, no more and no less") {
    const TemporaryFolder folder;
    for (const auto& [ratio, maximum] : known_maxima) {
        CAPTURE(ratio, maximum);
        const std::string file = certificate(folder, ratio);
        check_verified(verifier({"--ratio", ratio, "--exactly", std::to_string(maximum), file}));
        check_rejected(verifier({"--ratio", ratio, "--max", std::to_string(maximum - 1), file}));
        check_rejected(verifier({"--ratio", ratio, "--min", std::to_string(maximum + 1), file}));
        check_rejected(verifier({"--ratio", "7", "--max", "1000", file}));
    }
}

TEST_CASE("ranges with narrow gaps, at critical ratios and beyond 1000 are verified") {
    const TemporaryFolder folder;
    check_verified(verifier({certificate(folder, "4.60333884875:4.60333884876", {"--gap", "1e-3"})}));
    check_verified(verifier({certificate(folder, "1:30", {"--gap", "1e-10"})}));
    check_verified(verifier({certificate(folder, "1:1.0000000001")}));
    check_verified(verifier({certificate(folder, "1e3:2e3")}));
    check_verified(verifier({certificate(folder, "999999:1e6")}));
}

TEST_CASE(
    "ranges of the full section next to critical ratios are verified, and say what holds of the heavy mass") {
    const TemporaryFolder folder;
    for (const char* range : some_of(std::vector<const char*>{"1:1.01", "11.3622:11.3623", "4.6:4.61"}, 2)) {
        CAPTURE(range);
        const std::string path = certificate(folder, range, {"--section", "full", "--gap", "1e-5"});
        const Outcome verified = verifier({path});
        CHECK(verified.code == 0);
        CHECK_THAT(last_line(verified.out), Contains(" open=0 ") && Contains(" heavy-at-most=1 sha256="));
    }
    for (const char* range : {"2", "2:2.02", "5:5.01", "11:11.01"}) {
        CAPTURE(range);
        const std::string path = certificate(folder, range, {"--section", "plain"});
        CHECK(verifier({path}).code == 0);
    }
}

TEST_CASE("dumbbell verify passes arguments, output and exit code through") {
    const TemporaryFolder folder;
    const std::string ten = certificate(folder, "10");
    write_file(folder / "empty.dbc", "");
    write_file(folder / "foreign.dbc",
               replaced(contents(ten), "dumbbell-certificate 1", "dumbbell-certificate 9"));
    for (const Words& words : std::vector<Words>{{ten},
                                                 {"--ratio", "10", "--exactly", "4", ten},
                                                 {"--ratio", "10", "--exactly", "5", ten},
                                                 {"--json", ten},
                                                 {folder / "empty.dbc"},
                                                 {folder / "foreign.dbc"},
                                                 {folder / "missing.dbc"},
                                                 {ten, folder / "empty.dbc"},
                                                 {folder.path()},
                                                 {"--frobnicate"},
                                                 {},
                                                 {"--help"},
                                                 {"--version"},
                                                 {"-h"},
                                                 {"-V"}}) {
        const Outcome direct = verifier(words);
        Words through = words;
        through.insert(through.begin(), "verify");
        const Outcome passed = dumbbell(through);
        CAPTURE(direct.out, direct.err);
        CHECK(passed.code == direct.code);
        CHECK(passed.out == direct.out);
        CHECK(passed.err == direct.err);
    }
}

TEST_CASE("without its verifier next to it the program says so") {
    const TemporaryFolder folder;
    std::filesystem::copy_file(DUMBBELL_BIN, folder / "dumbbell");
    const Outcome result = run({folder / "dumbbell", "verify", "file.dbc"});
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK_THAT(result.err, Contains("dumbbell-verify"));
}

// A copy of the program, beside which the verifier is this script.
static std::string with_verifier(const TemporaryFolder& folder, const std::string& script) {
    std::string copy = folder / "dumbbell";
    const std::string beside = folder / "dumbbell-verify";
    std::filesystem::copy_file(DUMBBELL_BIN, copy);
    write_file(beside, "#!/bin/sh\n" + script);
    std::filesystem::permissions(beside, std::filesystem::perms::owner_all);
    return copy;
}

TEST_CASE("what is drawn and said of a file is of the bytes that the verifier accepted", "[wings]") {
    const TemporaryFolder folder;
    const std::string certificates = std::string(DUMBBELL_PROJECT) + "/certificates/";
    const std::string program =
        with_verifier(folder, "mv second first\nexec " DUMBBELL_VERIFY_BIN " \"$@\"\n");
    const auto exchanged = [&](const std::string& first, const std::string& second, Words words) {
        std::filesystem::copy_file(first, folder / "first",
                                   std::filesystem::copy_options::overwrite_existing);
        std::filesystem::copy_file(second, folder / "second");
        words.insert(words.begin(), program);
        return run(words, folder.path());
    };
    const std::string old = certificate(folder, "3:80"), stairs = certificates + "stairs-1-100.dbc";
    for (const Words& words : {Words{"plot", "staircase", "first", "--out", "x.svg"},
                               Words{"plot", "orbit", "first", "--ratio", "50", "--out", "x.svg"}}) {
        const Outcome outcome = exchanged(old, stairs, words);
        CAPTURE(words, outcome.err, outcome.out);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, Contains("'first' was changed while it was read and verified"));
        CHECK_FALSE(std::filesystem::exists(folder / "x.svg"));
        CHECK(exchanged(stairs, stairs, words).code == 0);
        std::filesystem::remove(folder / "x.svg");
    }
}

TEST_CASE("a signal that comes while a certificate is verified ends the verifier, too", "[wings]") {
    const TemporaryFolder folder;
    Process process(
        {with_verifier(folder, "echo $$ > number.tmp && mv number.tmp number\nexec sleep 1000\n"), "plot",
         "staircase", DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc", "--out", "x.svg"},
        folder.path());
    REQUIRE(process.until([&] { return std::filesystem::exists(folder / "number"); }));
    process.send(SIGTERM);
    const Outcome outcome = process.wait();
    CAPTURE(outcome.err);
    CHECK(outcome.signal == SIGTERM);
    CHECK_THAT(outcome.err, StartsWith("dumbbell: stopped by SIGTERM: "));
    CHECK(count_lines(outcome.err) == 1);
    CHECK(::kill(std::stoi(contents(folder / "number")), 0) != 0);
}
