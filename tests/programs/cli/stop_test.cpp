// SIGINT and SIGTERM: the program ends by them, soon, and says in one line what is kept.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const Words long_proof{"certify", "1:30000", "--gap", "1e-14", "--out", "stairs.dbc"};

/// Sends the signal once the job has had a tenth of a second of the processor: it takes ten times as long, or
/// more.
Outcome stopped(const Words& arguments, int signal, const TemporaryFolder& folder) {
    Process process(with_program(arguments), folder.path());
    process.until([&] { return process.cpu_seconds() > 0.1; });
    process.send(signal);
    return process.wait();
}

/// Sends it to a proof of a range once some pieces are kept; again if that was done before the signal came.
Outcome stopped_range(int signal, const TemporaryFolder& folder, const Words& proof = long_proof) {
    for (;;) {
        Process process(with_program(proof), folder.path());
        process.until([&] { return kept(folder / "stairs.dbc.partial") >= 12; });
        process.send(signal);
        Outcome outcome = process.wait();
        if (outcome.code != 0) {
            return outcome;
        }
        std::filesystem::remove(folder / "stairs.dbc");
    }
}

}  // namespace

TEST_CASE("a range that is stopped says what is kept, and the same command goes on to the same bytes") {
    const TemporaryFolder undisturbed;
    REQUIRE(dumbbell(long_proof, undisturbed.path()).code == 0);
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        const Outcome outcome = stopped_range(signal, folder);
        CAPTURE(outcome.err);
        REQUIRE(outcome.signal == signal);
        CHECK(outcome.out.empty());
        CHECK(count_lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, StartsWith(signal == SIGINT ? "dumbbell: stopped by SIGINT: "
                                                            : "dumbbell: stopped by SIGTERM: "));
        CHECK_THAT(outcome.err, Contains(" pieces are finished and kept in 'stairs.dbc.partial'") &&
                                    Contains("the same command goes on"));
        CHECK(folder.names() == Words{"stairs.dbc.partial"});
        for (const auto& entry : std::filesystem::directory_iterator(folder / "stairs.dbc.partial")) {
            const std::string piece = entry.path().string();
            CHECK((!piece.ends_with(".dbc") || verifier({piece}).code == 0));
        }
        CHECK_THAT(dumbbell({"certify", "100", "--out", "stairs.dbc"}, folder.path()).err,
                   Contains("'stairs.dbc.partial' holds the finished pieces of another run"));
        REQUIRE(dumbbell(long_proof, folder.path()).code == 0);
        CHECK(contents(folder / "stairs.dbc") == contents(undisturbed / "stairs.dbc"));
        CHECK(folder.names() == Words{"stairs.dbc"});
    }
}

TEST_CASE("without a file, and for a single ratio, a stopped run says that nothing is kept", "[wings]") {
    const TemporaryFolder folder;
    for (const auto& [arguments, said] : std::vector<std::pair<Words, const char*>>{
             {{"certify", "1:100000000", "--gap", "1e-9"}, "with --out FILE they are kept"},
             {{"certify", "1e100", "--out", "one.dbc"}, "nothing is kept of a single ratio"},
             {{"critical", "20000", "--digits", "200"}, "nothing is kept"},
             {{"trace", "100", "--phi", "0:6", "--phidot", "-1:1", "--y", "2", "--ydot", "-1", "--subdivide",
               "--max-boxes", "10000000", "--out", "box.dbc"},
              "nothing is kept; with --budget TIME"},
             {{"trace", "1e8", "--phi", "1/3", "--phidot", "100", "--y", "3", "--ydot", "-1/200", "--digits",
               "10000"},
              "nothing is kept of the "},
             {{"law", "--prove", "--out", "law.dbc"}, "not proved; no certificate is written"},
             {{"critical", "3:3000", "--digits", "100", "--out", "a.tsv"}, "with --budget TIME"}}) {
        const Outcome outcome = stopped(arguments, SIGINT, folder);
        CAPTURE(arguments, outcome.err, outcome.code);
        CHECK(outcome.signal == SIGINT);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, Contains("dumbbell: stopped by SIGINT: "));
        // It may not have come so far.
        CHECK_THAT(outcome.err, Contains(said) || Contains("no piece was finished yet"));
        CHECK(folder.names().empty());
    }
}

TEST_CASE("a range that is stopped while it looks for its steps says what an earlier run has kept") {
    const TemporaryFolder folder;
    const Words slow_steps{"certify", "1:4000000", "--gap", "1e-14", "--jobs", "1", "--out", "stairs.dbc"};
    REQUIRE(stopped_range(SIGINT, folder, slow_steps).signal == SIGINT);
    const Outcome again = stopped(slow_steps, SIGINT, folder);
    CAPTURE(again.err);
    CHECK(again.signal == SIGINT);
    CHECK_THAT(again.err, Contains(" pieces are finished and kept in 'stairs.dbc.partial'"));
    CHECK_THAT(again.err, !Contains(" of "));  // how many it will have is not known
}

TEST_CASE("a stopped run ends early, in the middle of a section without end too") {
    const TemporaryFolder folder;
    CHECK(stopped({"certify", "1e16", "--section", "full"}, SIGTERM, folder).signal == SIGTERM);
    CHECK(stopped({"critical", "10^17", "--digits", "200", "--budget", "1h"}, SIGTERM, folder).signal ==
          SIGTERM);
}

TEST_CASE("a signal that was ignored from the beginning stays ignored") {
    const TemporaryFolder folder;
    Process process({"sh", "-c", "trap '' INT; exec " DUMBBELL_BIN " certify 1:30000 --gap 1e-14"});
    process.until([&] { return process.cpu_seconds() > 0.1; });
    process.send(SIGINT);
    CHECK(process.wait().code == 0);
}
