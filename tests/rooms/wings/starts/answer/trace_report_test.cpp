#include "starts/answer/trace_report.hpp"

#include "catch.hpp"
#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_test::parsed;

namespace {

TraceReport report_of(const Rational& phi, const Rational& phidot, int digits) {
    const std::array<Rational, axis_count> at{phi, phidot, 3, -1, 10};
    TraceReport report{.box = {at, at}, .trace = {}, .digits = digits, .parts = {}, .out = {}, .sha256 = {}};
    report.trace = trace(report.box, digits);
    return report;
}

}  // namespace

TEST_CASE("a flat fall is said to be one, at every precision, with what to do") {
    for (const int digits : {0, 40, most_trace_digits}) {
        TraceReport report = report_of(0, 0, 0);
        report.digits = digits;
        CHECK_THAT(outcome_sentence(report),
                   Contains("cannot be decided at any precision") &&
                       Contains("both masses reach the floor at once, at time 3 ") &&
                       Contains("move the initial condition") && !Contains("--digits"));
    }
}

TEST_CASE("other undecided orbits want more digits, and once that did not help, another start") {
    TraceReport report = report_of(Rational(1) / exact(0x1p100), 0, 0);
    REQUIRE_FALSE(report.trace.exact());
    CHECK_THAT(outcome_sentence(report), Contains("try --digits 40") && !Contains("move"));
    report.digits = 40;
    CHECK_THAT(outcome_sentence(report),
               Contains("try --digits 80;") && Contains("move the initial condition"));
    report.digits = most_trace_digits;
    CHECK_THAT(outcome_sentence(report), !Contains("--digits") && Contains("move the initial condition"));
}

TEST_CASE("a box that splits is to be subdivided, unless it is") {
    TraceReport report = report_of(1, 0, 0);
    report.box.lo[0] = 0;
    report.box.hi[0] = 3;
    report.trace = trace(report.box, 0);
    REQUIRE_FALSE(report.trace.exact());
    CHECK_THAT(outcome_sentence(report),
               EndsWith("the box splits at collision 1 (smaller boxes: --subdivide)"));
    report.parts.emplace();
    CHECK_THAT(outcome_sentence(report), EndsWith("the box splits at collision 1"));
}

TEST_CASE("one collision is no plural") {
    TraceReport report = report_of(1, 0, 0);
    report.parts.emplace();
    report.parts->least = 1;
    report.parts->most = 1;
    CHECK_THAT(to_text(report), Contains("every initial condition in it has 1 collision.\n"));
    report.parts->most = 4;
    CHECK_THAT(to_text(report), Contains("every initial condition in it has between 1 and 4 collisions.\n"));
    report.parts->most.reset();
    CHECK_THAT(to_text(report), Contains("every initial condition in it has at least 1 collision.\n"));
}

TEST_CASE("a bound that is the one of all trajectories is said to be that") {
    TraceReport report = report_of(Rational(1) / exact(0x1p100), 0, 0);
    REQUIRE_FALSE(report.trace.exact());
    const std::string theorem = "No trajectory at mass ratio 10 has more than 4 collisions (theorem 1";
    CHECK(report.trace.most == 4);
    CHECK_THAT(to_text(report), Contains("between 1 and 4 collisions") && !Contains("theorem"));
    report.maximum = 4;
    CHECK_THAT(to_text(report), Contains("between 1 and 4 collisions") && Contains(theorem));
    CHECK(parsed(to_json(report))["most"] == 4);
    CHECK(parsed(to_json(report))["maximum"] == 4);
    CHECK(parsed(to_json(report))["rests_on"] == "proofs/theorem.md, theorem 1");
    report.trace.most = 3;
    CHECK_THAT(to_text(report), Contains("between 1 and 3 collisions") && !Contains("theorem"));
    CHECK(parsed(to_json(report))["maximum"].is_null());
    CHECK(parsed(to_json(report))["rests_on"].is_null());
    report.parts.emplace();
    report.parts->least = 1;
    report.parts->most = 4;
    report.parts->undecided.share = Rational(1, 3);
    report.box.hi[4] = 11;
    CHECK_THAT(to_text(report), Contains("every initial condition in it has between 1 and 4 collisions.\n") &&
                                    Contains("No trajectory at mass ratios up to 11 has more than 4"));
}

TEST_CASE("shares are rounded so that what is said to be certified is") {
    TraceReport report = report_of(1, 0, 0);
    report.parts.emplace();
    report.parts->least = report.parts->most.emplace(1);
    const Rational little(Integer(1), 3 * pow(Integer(10), 20));
    report.parts->exact[1] = {1 - little, 5};
    report.parts->undecided = {little, 1};
    CHECK_THAT(to_text(report), Contains("  0.999999999999          5\n") &&
                                    Contains("  3.33333333334e-21          1\n") &&
                                    Contains("Certified: 0.999999999999 of the box"));
    CHECK(parsed(to_json(report))["parts"]["decided_fraction"] < 1);
}

TEST_CASE("no zero has a sign") {
    const TraceReport report = report_of(Rational(3, 10), 0, 0);  // phidot is 0 before the first collision
    REQUIRE_FALSE(report.trace.collisions.empty());
    CHECK_THAT(to_json(report).text(), !Contains("-0.0,") && !Contains("-0.0]"));
}

TEST_CASE("the mass ratio is printed exactly") {
    TraceReport report = report_of(1, 0, 0);
    report.box.lo[4] = report.box.hi[4] = parse_rational("10.00000000000000000000000000001");
    CHECK_THAT(to_text(report), Contains("Mass ratio 10.00000000000000000000000000001;"));
}
