// Files about initial conditions as a script sees them: last line, exit code, options.
#include "catch.hpp"
#include "make_file.hpp"
#include "rooms/verify/program/run_program.hpp"

using make::falling;
using make::File;
using make::has;
using make::mutated;
using make::Run;
using make::run;

namespace {
const std::string ask = "--claim initial-conditions ";
}

TEST_CASE("initial conditions: the verdict names the box, the bounds and the share") {
    const File good(falling()), bad(mutated(falling(), "exactly 1 heavy", "exactly 2 heavy"));
    const Run verified = run(good.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() ==
          "s VERIFIED claim=initial-conditions phi=-1/1:1/1 phidot=1/100:1/100 y=3/2:3/2 ydot=-1/1:-1/1 "
          "ratio=10/1:10/1 collisions=1:5 decided=0.781250000000 sha256=" +
              falling().substr(falling().size() - 65, 64));
    CHECK(run(bad.path()).code == 1);
    CHECK(run(bad.path()).last() ==
          "s REJECTED line=36 code=exactly not certified: at least so many collisions");
    CHECK_FALSE(has(run(bad.path()), "VERIFIED"));
    CHECK(run("--precision 120 " + good.path()).code == 0);
    CHECK(run("--jobs 1 " + good.path()).out == run("--jobs 7 " + good.path()).out);
}

TEST_CASE("initial conditions: demands are about the box, and must say so") {
    const File file(falling());
    const auto code = [&](const std::string& options) { return run(options + " " + file.path()).code; };
    for (const char* demand : {"--max 5", "--min 1", "--exactly 2", "--ratio 10"}) {
        CHECK(code(demand) == 2);
        CHECK(has(run(std::string(demand) + " " + file.path()).last(), "--claim initial-conditions"));
    }
    CHECK(code(ask + "--exactly 5") == 1);
    CHECK(code(ask + "--ratio 0.1") == 2);
    CHECK(code(ask + "--ratio 10:11") == 1);
    CHECK(code(ask + "--scene body") == 1);
    CHECK(code("--claim collisions") == 1);
    CHECK(code("--claim other") == 2);
    const File open(
        make::closed(make::initial_header("10/1 10/1", "0/1 1/1", "1/1 1/1", "2/1 2/1", "-1/1 -1/1") +
                     "between 0 none\nopen\n"));
    CHECK(has(run(open.path()).last(), " collisions=0:none decided=0.000000000000 "));
    CHECK(run(ask + "--max 999 " + open.path()).code == 1);
}

TEST_CASE("initial conditions: --json and --explain") {
    const File file(falling());
    const Run json = run("--json " + file.path());
    CHECK(json.code == 0);
    CHECK(has(json,
              "\"claim\":{\"kind\":\"initial-conditions\",\"box\":{\"phi\":{\"lo\":\"-1/1\",\"hi\":\"1/"
              "1\"}"));
    CHECK(has(json, "\"least\":1,\"most\":5,\"decided\":\"25/32\"}"));
    CHECK(has(json, "\"leaves\":{\"split\":11,\"exactly\":7,\"between\":5,\"open\":0}"));
    const Run leaf = run("--explain box.11 " + file.path());
    CHECK(leaf.code == 0);
    CHECK(leaf.out.find("box.11, line 36: exactly 1 heavy 91b-6 373b-8\n") == 0);
    CHECK(has(leaf, "phi in [1/2, 1]"));
    CHECK(has(leaf, "falling in [t0, t1]: holds"));
    CHECK(has(leaf, "  certified\n"));
    for (const char* none : {"box.1", "box", "1:box", "box.111"}) {
        CHECK(run(std::string("--explain ") + none + " " + file.path()).code == 2);
    }
}

TEST_CASE("initial conditions: with just too little memory for a deep tree that is what the exit code says") {
    if (make::sanitized) return;
    std::string deep;  // 400 splits of each axis
    for (int i = 0; i < 400; ++i) deep += "split phi\nsplit phidot\nsplit y\nsplit ydot\nsplit q\n";
    for (int i = 0; i <= 2000; ++i) deep += "open\n";
    const std::string text =
        make::closed(make::initial_header("2/1 3/1", "0/1 1/1", "1/2 1/1", "1/1 2/1", "1/1 2/1") +
                     "between 0 none\n" + deep);
    for (const std::string& bytes : {text, make::gzipped(text)}) {
        const File file(bytes);
        const auto code = [&](int kilobytes) {
            return run("--quiet --jobs 1 " + file.path(), "ulimit -v " + std::to_string(kilobytes) + "; ")
                .code;
        };
        int too_little = 4'000, enough = 100'000;
        while (enough - too_little > 4) {
            const int middle = (too_little + enough) / 2;
            (code(middle) == 0 ? enough : too_little) = middle;
        }
        CHECK(code(enough + 2'000) == 3);  // it is all open
        CHECK(run("--quiet " + file.path(), "ulimit -s 1024; ").code == 3);
        for (int less = 4; less < 900; less += less < 40 ? 4 : 60) {  // memory is taken in steps of 132
            const int found = code(enough - less);
            CHECK((found == 3 || found == 4));
        }
    }
}

TEST_CASE("initial conditions: --shares prints bounds from the leaves, of such a file and of one only") {
    const File file(falling());
    const std::string shown = run("--shares " + file.path()).out;
    CHECK(has(shown,
              "  collisions  share of the box with exactly that many: proved bounds\n"
              "           0  0.000000000000 to 0.000000000000\n"));
    CHECK(shown.substr(shown.rfind("\ns ")) ==
          run(file.path()).out.substr(run(file.path()).out.rfind("\ns ")));
    CHECK_FALSE(has(run(file.path()), "proved bounds"));
    CHECK(has(run("--shares --json " + file.path()),
              R"("shares":[{"least":0,"most":0,"lo":"0/1","hi":"0/1"})"));
    CHECK_FALSE(has(run("--json " + file.path()), "shares"));
    CHECK(run("--shares " + file.path() + " " + file.path()).code == 2);
    CHECK(run("--shares --quiet " + file.path()).code == 2);
    const File ten(make::ten());
    CHECK(run("--shares " + ten.path()).code == 2);
    CHECK(has(run("--shares " + ten.path()).last(), "dumbbell trace --subdivide"));
    const File bad(mutated(falling(), "exactly 1 heavy", "exactly 2 heavy"));
    CHECK_FALSE(has(run("--shares " + bad.path()), "proved bounds"));
}
