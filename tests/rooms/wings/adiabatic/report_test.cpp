#include "adiabatic/report.hpp"

#include "catch.hpp"
#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using dumbbell_test::parsed;

namespace {

Report report_of(Claim claim) {
    Proof proof;
    proof.hypotheses.claim = claim;
    proof.hypotheses.delta = {Rational(1, 1000), Rational(1, 100)};
    proof.hypotheses.heights = {Rational(0), Rational(9, 10)};
    proof.hypotheses.margin = Rational(3, 10);
    proof.leaves = 7;
    proof.attained = {{Rational(1, 2), Rational(1), Rational(1, 100), 63, Rational(15)}};
    proof.bounds = {Rational(167, 10)};
    if (claim == Claim::bounce) {
        proof.bounds.emplace_back(12);
        proof.attained.push_back(proof.attained[0]);
    }
    return {"thm3.3", Rational(1, 10), {{proof, 0}}, {}, {}};
}

}  // namespace

TEST_CASE("The report says for which states, what is proved, and what one orbit attains") {
    const std::string text = to_text(report_of(Claim::run));
    CHECK_THAT(
        text, Contains("For every delta in [0.001, 0.01], epsilon = delta^2") &&
                  Contains("|phidot| = 1 and -delta <= ydot <= 0") && Contains("height y from 0 to 0.9") &&
                  Contains("|phi - 3 pi/2| >= 0.3 from the vertical") && Contains("any number n of bounces"));
    CHECK_THAT(text, Contains("|I_n - I_0| <= 16.7 delta\n") &&
                         Contains("at least 15 delta (delta = 0.01, distance 0.5 from the "
                                  "vertical, ydot = -1 delta, n = 63)"));
    CHECK_THAT(text, Contains("upper/lower at most 1.12\n"));  // 1.11333..., rounded up
}

TEST_CASE("An orbit's numbers are short, and said to be about right unless they are exact") {
    Report report = report_of(Claim::run);
    report.results[0].proof.attained[0].u = exact(0.050000049999999997);
    report.results[0].proof.attained[0].s = exact(0.91666666666666663);
    CHECK_THAT(to_text(report),
               Contains("distance about 0.05000005 from the vertical, ydot about -0.9166667 delta, n = 63)"));
    report.results[0].proof.attained[0].s = 0;
    CHECK_THAT(to_text(report), Contains("from the vertical, ydot = 0, n = 63)"));
}

TEST_CASE("A bound that is not as near as was aimed at is still said to be proved") {
    Report report = report_of(Claim::run);
    report.results[0].proof.coarser = true;
    CHECK_THAT(to_text(report), Contains("The bound is proved; it exceeds what is attained by more than"));
}

TEST_CASE("The units are those of each statement") {
    CHECK_THAT(to_text(report_of(Claim::scattering)), Contains("|I_N - I_0| <= 16.7 sqrt(delta)") &&
                                                          Contains(">= 0.3 sqrt(delta) from the vertical") &&
                                                          Contains("the heavy mass is not touched"));
    CHECK_THAT(to_text(report_of(Claim::bounce)), Contains("<= 16.7 delta\n") &&
                                                      Contains("<= 12 * 2 delta^(3/2)\n") &&
                                                      Contains("0.3 delta^(1/2)"));
    Report all = report_of(Claim::bounce);
    all.results[0].proof.hypotheses.exponent = 0;
    CHECK_THAT(to_text(all),
               Contains("<= 16.7 delta^2\n") && Contains("<= 12 * 2 delta^2\n") && Contains(">= 0.3 from"));
    all.results[0].proof.hypotheses.exponent = 16;
    CHECK_THAT(to_text(all), Contains("<= 16.7\n") && Contains("<= 12 * 2 delta\n"));
    CHECK(parsed(to_json(all)).at("results").at(0).at("errors").at(0).at("unit") == "1");
    all.results.push_back(all.results[0]);
    CHECK_THAT(to_text(all), !Contains("16.7 1"));
    Report from_zero = report_of(Claim::run);
    from_zero.results[0].proof.hypotheses.delta.first = 0;
    CHECK_THAT(to_text(from_zero), Contains("For every delta in (0, 0.01], "));
}

TEST_CASE("What was not certified is said to be so") {
    Report report = report_of(Claim::run);
    report.results[0].proof.bounds.clear();
    CHECK_THAT(to_text(report),
               Contains("no bound was certified") && Contains("attained") && !Contains("upper/lower"));
    CHECK(parsed(to_json(report)).at("results").at(0).at("errors").at(0).at("bound").is_null());
}

TEST_CASE("Several distances make a table") {
    Report report = report_of(Claim::run);
    report.results.push_back(report.results[0]);
    report.results[1].proof.hypotheses.margin = Rational(1, 2);
    CHECK_THAT(to_text(report), Contains("distance") &&
                                    Contains("     0.3  |I_n - I_0|  16.7 delta  15 delta   1.12") &&
                                    Contains("     0.5  |I_n - I_0|"));
}

TEST_CASE("The JSON holds the exact numbers") {
    const auto json = parsed(to_json(report_of(Claim::run)));
    const auto& result = json.at("results").at(0);
    CHECK(result.at("claim") == "adiabatic-run");
    CHECK(result.at("y").at("hi") == "9/10");
    CHECK(result.at("k").is_null());
    CHECK(result.at("errors").at(0).at("bound") == "167/10");
    CHECK(result.at("errors").at(0).at("ratio").get<double>() >= 16.7 / 15);
    CHECK(result.at("errors").at(0).at("attained").at("n") == 63);
}
