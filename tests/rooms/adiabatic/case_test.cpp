#include "adiabatic/case.hpp"

#include <catch2/catch.hpp>

#include "base/error.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using Catch::Matchers::Contains;

namespace {

using Cells = std::vector<std::string>;

AdiabaticHypotheses statement(AdiabaticClaim claim) {
    AdiabaticHypotheses of;
    of.claim = claim;
    of.delta = {Rational(1, 100), Rational(3, 100)};
    of.heights = {0, Rational(9, 10)};
    of.margin = Rational(1, 2);
    return of;
}

}  // namespace

TEST_CASE("a statement is spelt with what belongs to it, and read back") {
    AdiabaticHypotheses bounce = statement(AdiabaticClaim::bounce);
    bounce.exponent = 4;
    CHECK(case_of(bounce) == "case adiabatic-bounce 1/100 3/100 0/1 9/10 1/2 1/4");
    CHECK(columns_of(bounce) == Cells{"cor3.2", "0.01", "0.03", "0", "0.9", "0.5", "0.25"});
    const AdiabaticHypotheses run = statement(AdiabaticClaim::run);
    CHECK(case_of(run) == "case adiabatic-run 1/100 3/100 0/1 9/10 1/2 -");
    CHECK(columns_of(run) == Cells{"thm3.3", "0.01", "0.03", "0", "0.9", "0.5", "-"});
    const AdiabaticHypotheses scattering = statement(AdiabaticClaim::scattering);
    CHECK(case_of(scattering) == "case adiabatic-scattering 1/100 3/100 - - 1/2 -");
    AdiabaticHypotheses printed = statement(AdiabaticClaim::printed);
    printed.delta.second = printed.delta.first;
    CHECK(case_of(printed) == "case adiabatic-printed 1/100 1/100 - - 1/2 -");
    CHECK(columns_of(printed) == Cells{"printed", "0.01", "0.01", "-", "-", "0.5", "-"});
    for (const AdiabaticHypotheses& of : {bounce, run, scattering, printed}) {
        const AdiabaticHypotheses read = parse_case(case_of(of));
        CHECK(read.claim == of.claim);
        CHECK(read.delta == of.delta);
        CHECK(read.margin == of.margin);
        CHECK(read.exponent == of.exponent);
        CHECK((columns_of(of)[3] == "-" || read.heights == of.heights));
    }
}

TEST_CASE("a number may have as many digits as the command line takes") {
    AdiabaticHypotheses of = statement(AdiabaticClaim::run);
    of.delta.second = parse_rational("0.03" + std::string(990, '7'));
    CHECK(parse_case(case_of(of)).delta == of.delta);
}

TEST_CASE("what is spelt otherwise, or makes no sense, is no statement") {
    for (const char* unit : {
             "",
             "case",
             "case adiabatic-run 1/100 3/100 0/1 9/10 1/2",
             "case adiabatic-run 1/100 3/100 0/1 9/10 1/2 - -",
             "Case adiabatic-run 1/100 3/100 0/1 9/10 1/2 -",
             "case adiabatic-walk 1/100 3/100 0/1 9/10 1/2 -",
             "case adiabatic-run 0.01 3/100 0/1 9/10 1/2 -",
             "case adiabatic-run 2/200 3/100 0/1 9/10 1/2 -",
             "case adiabatic-run -1/100 3/100 0/1 9/10 1/2 -",
             "case adiabatic-run 3/100 1/100 0/1 9/10 1/2 -",
             "case adiabatic-run 1/100 3/4 0/1 9/10 1/2 -",
             "case adiabatic-run 1/100 3/100 9/10 0/1 1/2 -",
             "case adiabatic-run 1/100 3/100 - - 1/2 -",
             "case adiabatic-run 1/100 3/100 0/1 9/10 0/1 -",
             "case adiabatic-run 1/100 3/100 0/1 9/10 1/0 -",
             "case adiabatic-run 1/100 3/100 0/1 9/10 1/2 1/2",
             "case adiabatic-scattering 1/100 3/100 0/1 1/1 1/2 -",
             "case adiabatic-scattering 0/1 3/100 - - 1/2 -",
             "case adiabatic-bounce 1/100 3/100 0/1 9/10 1/2 -",
             "case adiabatic-bounce 1/100 3/100 0/1 9/10 1/2 8/16",
             "case adiabatic-bounce 1/100 3/100 0/1 9/10 1/2 1/3",
             "case adiabatic-bounce 1/100 3/100 0/1 9/10 1/2 17/16",
         }) {
        CAPTURE(unit);
        CHECK_THROWS_AS(parse_case(unit), InputError);
    }
    CHECK_THROWS_WITH(parse_case("case adiabatic-run 1/100 3/4 0/1 9/10 1/2 -"),
                      Contains("between 0 and 1/2"));
}

TEST_CASE("the options of a grid list each quantity once") {
    AdiabaticHypotheses of = statement(AdiabaticClaim::bounce);
    CHECK(options_of({of}) == "--theorem lemma3.1 --delta 0.01:0.03 --y 0:0.9 --phi-margin 0.5");
    std::vector<AdiabaticHypotheses> grid;
    for (const Rational& delta : {Rational(1, 3), Rational(1, 10)}) {
        of.delta = {delta, delta};
        for (const int exponent : {8, 4}) {
            of.exponent = exponent;
            grid.push_back(of);
        }
    }
    CHECK(options_of(grid) == "--theorem cor3.2 --delta 1/3,0.1 --y 0:0.9 --phi-margin 0.5 --k 0.5,0.25");
    CHECK(options_of({statement(AdiabaticClaim::scattering)}) ==
          "--theorem thm3.5 --delta 0.01:0.03 --phi-margin 0.5");
}
