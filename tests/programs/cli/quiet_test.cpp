// --quiet: the verdict alone, with the same exit code.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

// What the command prints with --quiet, which must be a part of what it prints without.
std::string quietly(Words command) {
    const Outcome loud = dumbbell(command);
    command.emplace_back("--quiet");
    const Outcome quiet = dumbbell(command);
    CAPTURE(command, loud.out, quiet.out);
    CHECK(quiet.code == loud.code);
    CHECK(quiet.err.empty());
    CHECK(count_lines(quiet.out) < count_lines(loud.out));
    return quiet.out;
}

}  // namespace

TEST_CASE("certify --quiet says in a sentence what is proved") {
    CHECK(quietly({"certify", "10"}) ==
          "Proved: at mass ratio 10 no trajectory hits the floor more than 4 times, and some trajectory hits "
          "it 4 "
          "times.\n");
    CHECK_THAT(quietly({"certify", "1:20"}),
               StartsWith("Proved: in each of the 4 pieces") && Contains("3 gaps"));
    CHECK(dumbbell({"certify", "10", "--quiet", "--witness"}).code == 2);
}

TEST_CASE("certify --quiet still says on stderr why it did not decide, with exit code 3") {
    const Outcome result = dumbbell({"certify", "1e16", "--quiet", "--budget", "0s"});
    CHECK(result.code == 3);
    CHECK_THAT(result.out, StartsWith("Not decided: "));
    CHECK(count_lines(result.err) == 1);
}

TEST_CASE("critical --quiet prints the ratios, a line each") {
    CHECK(quietly({"critical", "4"}) == "q_c(4) = 4.60333884875170...\n");
    CHECK(quietly({"critical", "3:5"}) ==
          "q_c(3) = 1\nq_c(4) = 4.60333884875170...\nq_c(5) = 11.3622592088388...\n");
}

TEST_CASE("trace --quiet prints the outcome, of a box with its parts") {
    CHECK(quietly({"trace", "10", "--phi", "1/3", "--phidot", "1", "--y", "3", "--ydot", "-1/2"}) ==
          "exactly 1 collision\n");
    CHECK_THAT(dumbbell({"trace", "10", "--phi", "0:3", "--phidot", "0", "--y", "3", "--ydot", "-1",
                         "--subdivide", "--max-boxes", "100", "--quiet"})
                   .out,
               Contains("share of the box") && Contains("Certified: "));
}

TEST_CASE("adiabatic --quiet prints the constant") {
    CHECK_THAT(quietly({"adiabatic", "--theorem", "lemma3.1", "--delta", "0.1"}),
               StartsWith("delta = 0.1, distance ") && Contains(" <= "));
}

TEST_CASE("verify --quiet prints the last line only: the verdict, or the numbers of several files") {
    const TemporaryFolder folder;
    const std::string file = certificate(folder, "10");
    const Outcome one = dumbbell({"verify", "--quiet", file});
    CHECK(one.code == 0);
    CHECK(count_lines(one.out) == 1);
    CHECK(one.out == last_line(dumbbell({"verify", file}).out) + "\n");
    CHECK_THAT(one.out, StartsWith("s VERIFIED "));
    CHECK(dumbbell({"verify", "--quiet", file, file}).out ==
          "c files=2 verified=2 rejected=0 limit=0 unsupported=0 unreadable=0 open=0 exit=0\n");
    const Outcome weak = dumbbell({"verify", "--quiet", "--ratio", "10", "--max", "3", file});
    CHECK(weak.code == 1);
    CHECK(count_lines(weak.out) == 1);
    CHECK_THAT(weak.out, StartsWith("s REJECTED "));
    CHECK(dumbbell({"verify", "--quiet", "--explain", "1:bridge", file}).code == 2);
}
