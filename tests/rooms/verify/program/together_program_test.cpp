// The option --together as a script sees it: last line, exit code, JSON, messages.
#include <deque>

#include "catch.hpp"
#include "make_together.hpp"
#include "programs/cli/process.hpp"
#include "run_program.hpp"

using make::Cuttable;
using make::File;
using make::has;
using make::Run;
using make::run;

namespace {

/// stairs-1-100.dbc in four files.
struct Quarters {
    std::deque<File> files;
    std::string names;  ///< each behind a space, not in the order of their ranges

    Quarters() {
        const Cuttable stairs(make::contents(make::shipped("stairs-1-100.dbc")));
        for (const auto& [first, many] : {std::pair(9, 4), {0, 4}, {13, 4}, {4, 5}})
            names += " " + files.emplace_back(stairs.with(first, many)).path();
    }
};
const std::string four_verdict =
    "s VERIFIED scene=dumbbell ratio=1/1:100/1 upper=10 lower=2 gaps=8 open=0 widest-gap=1.00e-6 files=4";

}  // namespace

TEST_CASE("together: the claim is judged for all files, the last line alone has a verdict") {
    const Quarters quarters;
    const Run r = run("--together --ratio 1:100 --max 10 --min 2 --gap 1e-6 --gaps 8" + quarters.names);
    CHECK(r.code == 0);
    const std::string demanded =
        four_verdict + " demanded-ratio=1/1:100/1 max=10 min=2 demanded-gap=1/1000000 demanded-gaps=8";
    CHECK(r.last() == demanded);
    std::string expected;
    for (const File& file : quarters.files)
        expected += file.path() + "\n  " + run("--quiet " + file.path()).last().substr(11) + "\n";
    CHECK(r.out ==
          expected +
              "  Proved: at every mass ratio from 1 to 100 no trajectory hits the floor more than 10 "
              "times, and some trajectory hits it at least 2 times; the greatest number is known "
              "in 9 of 17 pieces, one of two neighbouring values in 8; the stretches where it is not known "
              "have "
              "a relative width of at most 1.00e-6.\n" +
              demanded + "\n");
    CHECK(run("--quiet --together" + quarters.names).out == four_verdict + "\n");
    CHECK(run("--together --ratio 5:11 --exactly 4" + quarters.names).code == 0);
    CHECK(run("--together --claim collisions --scene dumbbell --precision 60" + quarters.names).code == 0);
    const Run weak = run("--quiet --together --ratio 1:100 --max 9" + quarters.names);
    CHECK(weak.code == 1);
    CHECK(weak.out ==
          "s REJECTED code=claim-not-proved not proved: at most 9 collisions for every mass ratio in "
          "1/1:100/1\n");
    CHECK(run("--together --ratio 1:101" + quarters.names).code == 1);
    const Run hole = run("--together " + quarters.files[0].path() + " " + quarters.files[1].path());
    CHECK(hole.code == 1);
    CHECK(hole.last().starts_with("s REJECTED code=chain a hole: " + quarters.files[1].path() + " ends at "));
    CHECK(run("--together --max 10 " + make::shipped("stairs-1-100.dbc")).last() ==
          make::replaced(four_verdict, "files=4", "files=1 max=10 not-demanded=ratio,min,gap,gaps"));
    const std::string first = quarters.files[0].path(), rest = quarters.names.substr(first.size() + 1);
    CHECK(run("--quiet --together -" + rest, "cat " + first + " | ").out == four_verdict + "\n");
}

TEST_CASE("together: neither threads nor the order of the files change the verdict") {
    const Quarters quarters;
    std::string backwards;
    for (const File& file : quarters.files) backwards = " " + file.path() + backwards;
    for (const char* jobs : {"1", "2", "8"})
        for (const std::string& names : {quarters.names, backwards})
            CHECK(run("--quiet --together --max 10 --jobs " + std::string(jobs) + names).out ==
                  four_verdict + " max=10 not-demanded=ratio,min,gap,gaps\n");
    const std::string all = "--together --jobs ";
    CHECK(run(all + "1" + quarters.names).out == run(all + "8" + quarters.names).out);
}

TEST_CASE("together: a file that is not verified is named, with its own exit code", "[wings]") {
    const Quarters quarters;
    const File bad(make::mutated(make::ten(), "upper 4", "upper 3"));
    const Run rejected = run("--together" + quarters.names + " " + bad.path() + " /nonexistent");
    CHECK(rejected.code == 1);
    CHECK(rejected.last() ==
          "s REJECTED code=count " + bad.path() + ": line 13: not certified: 1 + a + b <= U");
    const Run missing = run("--together" + quarters.names + " /nonexistent");
    CHECK(missing.code == 2);
    CHECK(missing.last() == "s UNREADABLE /nonexistent: No such file or directory");
    const Run name = run("--together 'no\ns VERIFIED such\r\033[2Jfile'");
    CHECK(name.out == "s UNREADABLE no?s VERIFIED such??[2Jfile: No such file or directory\n");
    CHECK(run("--together --budget 0.001s" + quarters.names).code == 0);  // each file has its own
    CHECK(run("--together --budget 0s" + quarters.names).code == 4);
    const Run law = run("--together " + make::shipped("law.dbc.gz"));
    CHECK(law.code == 2);
    CHECK(has(law.last(),
              ": --together is about ranges of mass ratios, and this file is about something else"));
    CHECK(run("--together --ratio 4 --max 16 " + make::shipped("coin.dbc")).code == 1);
}

TEST_CASE("together: JSON is one object, in which the demand is on the whole and not on the files") {
    const Quarters quarters;
    const Run r = run("--json --together --ratio 1:100 --max 10" + quarters.names);
    CHECK(r.code == 0);
    CHECK(r.out.starts_with(
        R"({"schema":"dumbbell-verify-together-1","verdict":"VERIFIED","claim":{"scene":"dumbbell",)"
        R"("ratio":{"lo":"1/1","hi":"100/1"},"rho":null,"upper":10,"lower":2,"pieces":17,"gaps":8,"open":0,)"
        R"("widest_gap":")"));
    CHECK(has(r.out, R"("demand":{"ratio":{"lo":"1/1","hi":"100/1"},"inertia":null,"rho":null,"max":10,)"));
    CHECK(has(r.out, R"("code":null,"reason":null,"files":[{"file":")" + quarters.files[0].path() +
                         R"(","verdict":"VERIFIED",)"));
    const std::string files = r.out.substr(r.out.find("\"files\":"));
    CHECK(
        has(files, R"("demand":{"ratio":null,"inertia":null,"rho":null,"max":null,"min":null,"gap":null,)"));
    CHECK_FALSE(has(files, R"("max":10)"));
    CHECK(files.ends_with("}]}\n"));
    const Run weak = run("--json --together --max 9" + quarters.names);
    CHECK(weak.code == 1);
    CHECK(has(weak, R"("verdict":"REJECTED","claim":null,"demand":{"ratio":null,)"));
    CHECK(has(weak, R"("code":"claim-not-proved","reason":"not proved: at most 9 )"));
}
