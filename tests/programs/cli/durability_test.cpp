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

TEST_CASE("killed during a long job, nothing is left but the folder of finished pieces") {
    const TemporaryFolder folder;
    Process process(slow, folder.path());
    wait_for_search(process, folder);
    process.kill();
    const Outcome outcome = process.wait();
    CHECK(outcome.signal == SIGKILL);
    CHECK(folder.names() == Words{"stairs.dbc.partial"});
}

TEST_CASE("killed during a long job, an older certificate of the same name stays as it was") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--out", "stairs.dbc"}, folder.path()).code == 0);
    const std::string before = contents(folder / "stairs.dbc");
    Process process(slow, folder.path());
    wait_for_search(process, folder);
    process.kill();
    CHECK(process.wait().signal == SIGKILL);
    CHECK(contents(folder / "stairs.dbc") == before);
}

TEST_CASE("what a program left that was killed while it wrote goes with the next one") {
    const TemporaryFolder folder;
    write_file(folder / "ten.dbc.dumbbell-tmp", "half a certif");
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    CHECK(folder.names() == Words{"ten.dbc"});
    CHECK(verifier({folder / "ten.dbc"}).code == 0);
}

TEST_CASE("a certificate of the same name is replaced") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--out", "file.dbc"}, folder.path()).code == 0);
    REQUIRE(dumbbell({"certify", "12", "--out", "file.dbc"}, folder.path()).code == 0);
    CHECK_THAT(contents(folder / "file.dbc"), Contains("ratio 12/1 12/1\n"));
    CHECK(folder.names() == Words{"file.dbc"});
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

TEST_CASE("a result that cannot be printed is no success") {
    for (const char* arguments : {"certify 10", "certify 10 --json", "--help", "--version"}) {
        CAPTURE(arguments);
        const Outcome result =
            run({"sh", "-c", std::string("exec " DUMBBELL_BIN " ") + arguments + " >/dev/full"});
        CHECK(result.code != 0);
        CHECK(count_lines(result.err) == 1);
    }
}
