// A killed program, a file that may not grow, closed streams: never half a file under the final name.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const Words slow{DUMBBELL_BIN, "certify", "1:1000000", "--gap", "1e-9", "--out", "stairs.dbc"};

void wait_for_search(const Process& process, const TemporaryFolder& folder) {
    REQUIRE(process.until([&] { return std::filesystem::exists(folder / "stairs.dbc.partial/claim"); }));
}

}  // namespace

TEST_CASE(
    "killed during a long job, what is left are the finished pieces, and an older certificate as it was") {
    const TemporaryFolder folder;
    write_file(folder / "stairs.dbc", "old");
    Process process(slow, folder.path());
    wait_for_search(process, folder);
    process.kill();
    const Outcome outcome = process.wait();
    CHECK(outcome.signal == SIGKILL);
    CHECK(folder.names() == Words{"stairs.dbc", "stairs.dbc.partial"});
    CHECK(contents(folder / "stairs.dbc") == "old");
}

TEST_CASE("a file that may not grow is like a full disk") {
    const TemporaryFolder folder;
    const Outcome result = run(
        {"sh", "-c", "ulimit -f 1; exec " DUMBBELL_BIN " certify 1:1000 --out stairs.dbc"}, folder.path());
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK(folder.names() == Words{"stairs.dbc.partial"});  // what was finished is not lost
}

TEST_CASE("no file that is opened gets the number of a standard stream that is closed") {
    const Outcome result =
        run({"timeout", "60", "sh", "-c",
             DUMBBELL_BIN " certify 1e16 --section full <&- >&- 2>&- & "
                          "cd /proc/$!/fd; "
                          "until [ \"$(readlink 0 1 2 | uniq -c | tr -d ' ')\" = 3/dev/null ]; do :; done; "
                          "kill $!"});
    CHECK(result.code == 0);
}
