// With stand-ins for the verifier: shell scripts.
#include "file/verifier_program.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell;
using namespace dumbbell_test;
namespace fs = std::filesystem;

namespace {

/// A program that does this, in a place of its own.
struct StandIn {
    TemporaryFolder folder;
    std::string program = folder / "stand-in";

    explicit StandIn(const std::string& script) {
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(program, fs::perms::owner_all);
    }
    [[nodiscard]] Verdict answer(std::vector<std::string> arguments = {}) const {
        return ask_verifier(std::move(arguments), program);
    }
};

}  // namespace

TEST_CASE("a verdict is the last line, and accepts if the exit code does") {
    const StandIn yes("echo details; echo s VERIFIED ratio=1/1:2/1 $2");
    CHECK(yes.answer({"--quiet", "a b"}).accepts);
    CHECK(yes.answer({"--quiet", "a b"}).line == "s VERIFIED ratio=1/1:2/1 a b");
    const StandIn no("echo s REJECTED line=13; exit 1");
    CHECK_FALSE(no.answer().accepts);
    CHECK(no.answer().line == "s REJECTED line=13");
    CHECK(StandIn("echo s OPEN upper=none; exit 3").answer().accepts);  // right, if it proves nothing
}

TEST_CASE("without a verdict nothing is said of the file") {
    for (const char* script : {"exit 0", "exit 1", "echo hello", "echo s VERIFIED x; exit 1", "echo s OPEN x",
                               "echo s VERIFIED x; exit 3", "echo s REJECTED x",
                               "echo s VERIFIED x; kill -9 $$", "kill -TERM $$", "exit 127"}) {
        CAPTURE(script);
        CHECK_THROWS_AS(StandIn(script).answer(), NoVerdict);
    }
    CHECK_THROWS_WITH(ask_verifier({}, "/no/such/verifier"), Contains("cannot start the verifier"));
}

TEST_CASE("children that nobody waits for have no exit code, and give no verdict") {
    const auto before = std::signal(SIGCHLD, SIG_IGN);
    CHECK_THROWS_AS(StandIn("echo s REJECTED x; exit 1").answer(), NoVerdict);
    CHECK_THROWS_AS(StandIn("echo s VERIFIED x").answer(), NoVerdict);
    std::signal(SIGCHLD, before);
}

TEST_CASE("the verifier gets none of this program's files") {
    const StandIn lists("echo s VERIFIED $(ls /proc/self/fd | tr '\\n' ' ')");
    const std::ifstream open("/proc/self/status");
    CHECK_THAT(lists.answer().line, !Contains(" 5") && !Contains(" 6"));
}
