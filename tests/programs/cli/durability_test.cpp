// A killed program, a full disk, a busy name: never half a file under the final name.
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>

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

TEST_CASE("what a program left that was killed while it wrote goes with the next one") {
    const TemporaryFolder folder;
    write_file(folder / "ten.dbc.dumbbell-tmp", "half a certif");
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    CHECK(folder.names() == Words{"ten.dbc"});
    CHECK(verifier({folder / "ten.dbc"}).code == 0);
}

TEST_CASE("a full disk: one line, exit 2, no file (needs the right to mount one)") {
    const TemporaryFolder folder;
    const std::string disk = folder / "disk";
    std::filesystem::create_directory(disk);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=4k") != 0) {
        WARN("skipped: only root can mount a small disk");
        return;
    }
    const Outcome result = dumbbell({"certify", "1:1000", "--out", disk + "/stairs.dbc"});
    CHECK(std::filesystem::is_empty(disk));
    ::umount(disk.c_str());
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK_THAT(result.err, Contains("No space left"));
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

TEST_CASE("a pipe is not replaced by a certificate") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe.dbc").c_str(), 0600) == 0);
    const Outcome result = dumbbell({"certify", "10", "--out", "pipe.dbc"}, folder.path());
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK(std::filesystem::is_fifo(folder / "pipe.dbc"));
}
