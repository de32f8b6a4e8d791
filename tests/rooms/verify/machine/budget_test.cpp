// What a file may cost, and from where it may come: as a script sees it.
#include <unistd.h>

#include <filesystem>

#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "rooms/verify/program/run_program.hpp"
#include "rooms/verify/program/shipped.hpp"

using namespace make;

namespace {

/// The count is one too low, so that doubles fail and 2048 bits are tried: 480 bytes that cost minutes.
std::string short_and_dear() {
    const std::string q = "1000000000000/1", leaf = "count 442797 442798\n";
    return closed(header(q, q, 1) + "piece " + q + " " + q + "\nbits 2048\nupper 885596\nchart bridge\n" +
                  leaf + "chart light\n" + leaf + "lower 0\n");
}
const std::string ten_path = shipped("q-10.dbc");

}  // namespace

TEST_CASE("budget: a short file that costs minutes is given up where the budget ends") {
    const File dear(short_and_dear());
    for (const auto& [options, budget] :
         {std::pair{"--jobs 1 --budget 0.1s ", "0.100 s"}, {"--jobs 3 --budget 0.25s ", "0.250 s"}}) {
        const Run r = run(options + dear.path());
        CHECK(r.code == 4);
        CHECK(r.last() == std::string("s LIMIT line=13 more work than the budget of ") + budget +
                              ": --budget allows more");
    }
}

TEST_CASE("budget: text costs, too, and what is enough for a file is told") {
    const Run none = run("--budget 0s " + ten_path);
    CHECK(none.code == 4);
    CHECK(has(none, "more work than the budget of 0 s"));
    CHECK(run("--budget 0.001s " + ten_path).code == 0);
    const Run json = run("--json --jobs 2 " + shipped("stairs-1-1e4.dbc.gz"));
    REQUIRE(has(json.out, "\"work\":0."));
    const std::string work = json.out.substr(json.out.find("\"work\":") + 7, 5);
    CHECK(run("--budget " + work + "s " + shipped("stairs-1-1e4.dbc.gz")).code == 0);
    const std::string less = std::to_string(std::stod(work) - 0.002).substr(0, 5);
    CHECK(run("--budget " + less + "s --jobs 1 " + shipped("stairs-1-1e4.dbc.gz")).code == 4);
    CHECK(has(run("--json --budget 0s " + ten_path).out, "\"work\":null"));
}

TEST_CASE("budget: each file has its own") {
    CHECK(run("--budget 0.001s " + ten_path + " " + ten_path + " " + ten_path).code == 0);
}

TEST_CASE("a certificate may come from the standard input, or from a pipe that the shell makes") {
    const std::string exactly = "--quiet --ratio 10 --exactly 4 ";
    const std::string verdict = run(exactly + ten_path).out;
    CHECK(run(exactly + "- <" + ten_path).out == verdict);
    CHECK(run(exactly + "-", "cat " + ten_path + " | ").out == verdict);
    for (const std::string pipe : {"/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"})
        CHECK(run(exactly + pipe, "cat " + ten_path + " | ").out == verdict);
    for (const std::string closed : {"", "exec <&-; "})  // it is file 0 then
        CHECK(run("--version; bash -c '" + closed + DUMBBELL_VERIFY_BIN " " + exactly + "<(sleep 0.1; cat " +
                  ten_path + ")'")
                      .last() +
                  "\n" ==
              verdict);
    CHECK(run(exactly + "- <&-").code == 2);
    CHECK(run(exactly + ten_path, "exec <&-; ").out == verdict);
}

TEST_CASE("a named pipe that nobody writes to is refused at once") {
    const std::string pipe =
        std::filesystem::temp_directory_path() / ("dumbbell_verify_pipe" + std::to_string(::getpid()));
    REQUIRE(std::system(("rm -f " + pipe + "; mkfifo " + pipe).c_str()) == 0);
    for (const std::string& options : {pipe, "--claims " + pipe}) {
        const Run r = run(options, "timeout 1000 ");
        INFO(options << r.out << r.err);
        CHECK(r.code == 2);
        CHECK(has(r.out + r.err, "a named pipe: give `-`"));
    }
    CHECK(has(run(pipe, "exec <&-; timeout 1000 "), "a named pipe: give `-`"));  // it is file 0 then
    std::filesystem::remove(pipe);
}

TEST_CASE("a small stack is enough") { CHECK(run(ten_path, "ulimit -s 128; ").code == 0); }

TEST_CASE("the stack that many bits need is taken at once, before the memory is used for anything else") {
    // Waits for its file while the kernel is asked how large its stack is, in KiB.
    const auto stack = [](const std::string& limit, int enough) {
        return "bash -c '" + limit + "coproc " DUMBBELL_VERIFY_BIN " -; for ((i = 0; i < 2000; ++i)); do " +
               "[[ $(< /proc/$COPROC_PID/status) =~ VmStk:[[:space:]]*([0-9]+) ]]; " +
               "((BASH_REMATCH[1] < " + std::to_string(enough) + ")) || exit 0; sleep 0.05; done; exit 1'";
    };
    CHECK(std::system(stack("", 256).c_str()) == 0);
    CHECK(std::system(stack("ulimit -s 512; ", 128).c_str()) == 0);
}

TEST_CASE("progress goes to a terminal only, without escape codes, and not with --quiet") {
    const std::string pieces = "zcat " + shipped("stairs-1-1e6.dbc.gz") + " | head -n 3000";
    // The first lines of a file, and then nothing more until that is shown (or two seconds, if nothing is):
    // progress is due on every machine.
    const auto on_terminal = [](const std::string& lines, const std::string& options,
                                const std::string& awaited) {
        const File seen("");
        const std::string wait = awaited.empty() ? "sleep 2"
                                                 : "for i in $(seq 3000); do grep -q \"" + awaited + "\" " +
                                                       seen.path() + " && break; sleep 0.1; done";
        return run("--version >/dev/null; script -qefc '(" + lines + "; " + wait +
                   ") | " DUMBBELL_VERIFY_BIN " " + options + " -' " + seen.path() + " </dev/null");
    };
    if (std::system("command -v script >/dev/null") == 0) {
        const Run shown = on_terminal(pieces, "--jobs 1", " of 1771 pieces, ");
        CHECK(has(shown.out, "\rverifying: "));
        CHECK(has(shown.out, " of 1771 pieces, "));
        CHECK_FALSE(has(shown.out, "\033"));
        CHECK(on_terminal(pieces, "--quiet", "").out.starts_with("s REJECTED "));
        CHECK(has(on_terminal("head -n 5 " + ten_path, "", "reading: "), "\rreading: 0 MB, 0 s of work"));
    }
    CHECK(run("-", "(" + pieces + "; sleep 2) | ").err.empty());
}
