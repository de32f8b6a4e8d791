#include "critical/report.hpp"

#include <sstream>

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::critical;
using dumbbell_test::parsed;

namespace {

Rational number(const char* text) { return parse_rational(text); }

Row row(long n, const char* lo, const char* hi) {
    return {n, Ratio{.n = n, .q_lo = number(lo), .q_hi = number(hi), .bits = 128}};
}

// q_c(3), q_c(4) to more than 15 digits, q_c(5) open.
Report sample() {
    Report report;
    report.request.first = 3;
    report.request.last = 5;
    report.request.digits = 6;
    report.request.jobs = 2;
    report.rows = {row(3, "1", "1"), row(4, "4.6033388487517", "4.6033388487518"), {5, {}}};
    report.seconds = 1.25;
    return report;
}

Report single(Row of) {
    Report report = sample();
    report.request.first = report.request.last = of.n;
    report.rows = {std::move(of)};
    return report;
}

}  // namespace

TEST_CASE("one ratio: its digits cut off, not rounded, with a radius that reaches the far end") {
    const std::string text = to_text(single(row(4, "4.6033388487517", "4.6033388487518")));
    CHECK_THAT(text, StartsWith("q_c(4) = 4.60333...\n"));
    CHECK_THAT(text, Contains("steps from 3 to 4") && Contains("within 8.9e-6 of the digits") &&
                         Contains("flight 1 of the corner orbit") && Contains("128 bits"));
}

TEST_CASE("the output says that it rests on theorem 2, and that the covers do not") {
    for (const std::string& text :
         {to_text(single(row(4, "4.6033388487517", "4.6033388487518"))), to_text(sample())}) {
        CHECK_THAT(
            text,
            Contains("theorem 2 of proofs/theorem.md, which the covers of\ndumbbell certify do not use"));
    }
    CHECK(parsed(to_json(sample())).at("rests_on") == "proofs/theorem.md, theorem 2");
    CHECK_THAT(to_tsv(sample()), Contains("theorem 2 of proofs/theorem.md"));
}

TEST_CASE("an exact ratio is a number without dots and with radius 0") {
    const std::string text = to_text(single(row(3, "1", "1")));
    CHECK_THAT(text, StartsWith("q_c(3) = 1\n"));
    CHECK_THAT(text, Contains("exact"));
    const auto json = parsed(to_json(sample())).at("ratios").at(0);
    CHECK(json.at("q_c") == "1");
    CHECK(json.at("radius") == "0");
    CHECK(json.at("exact") == true);
    CHECK(json.at("lo") == "1");
    CHECK(json.at("hi") == "1");
}

TEST_CASE("digits that the enclosure does not decide are never printed") {
    CHECK_THROWS_AS(to_text(single(row(4, "4.60333", "4.60334"))), BrokenInvariant);
}

TEST_CASE("several ratios are a table, open ones marked") {
    const std::string text = to_text(sample());
    CHECK_THAT(text, Contains("N  mass ratio of the step  to within  bits of precision\n"
                              "3  1                               0                128\n"
                              "4  4.60333...                 8.9e-6                128\n"
                              "5  open                            -                  -\n"
                              "3 critical ratios in 1.25 s with 2 threads\n"));
    CHECK_THAT(text, Contains("Not finished: 1 of 3 are open."));
    CHECK_THAT(to_text(single({5, {}})), Contains("not enclosed") && !Contains("Proved"));
}

TEST_CASE("the file has a row per ratio and nothing that depends on the run") {
    CHECK_THAT(to_tsv(sample()), EndsWith("# N\tq_c\tradius\tbits\torbit\tflight\n"
                                          "3\t1\t0\t128\ttop\t1\n"
                                          "4\t4.60333\t8.9e-6\t128\tcorner\t1\n"
                                          "5\topen\t-\t-\ttop\t2\n"));
}

TEST_CASE("JSON: numbers as decimals in strings, the enclosure rounded outward") {
    Report report = sample();
    report.rows[1].ratio->q_lo = number("4.6033388487517") + Rational(1) / exact(0x1p400);
    report.out = "ratios.tsv";
    const auto json = parsed(to_json(report));
    CHECK(json.at("schema") == "dumbbell-critical-1");
    CHECK(json.at("digits") == 6);
    CHECK(json.at("jobs") == 2);
    CHECK(json.at("open") == 1);
    CHECK(json.at("out") == "ratios.tsv");
    const auto four = json.at("ratios").at(1);
    CHECK(four.at("n") == 4);
    CHECK(four.at("q_c") == "4.60333");
    CHECK(four.at("radius") == "8.9e-6");
    CHECK(four.at("lo") == "4.6033388487517");
    CHECK(four.at("hi") == "4.6033388487518");
    CHECK(four.at("orbit") == "corner");
    CHECK(four.at("flight") == 1);
    CHECK(four.at("status") == "proved");
    const auto five = json.at("ratios").at(2);
    CHECK(five.at("status") == "open");
    CHECK_FALSE(five.contains("q_c"));
}
