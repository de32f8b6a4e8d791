#include "report/adiabatic_plot.hpp"

#include <catch2/catch.hpp>

#include "arith/error.hpp"
#include "xml.hpp"

using namespace dumbbell;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

AdiabaticCertificate sample(AdiabaticClaim claim, long n) {
    AdiabaticCertificate certificate;
    certificate.hypotheses.claim = claim;
    certificate.bounds = {Rational(51204, 10000)};
    certificate.attained = {{Rational(9, 10), Rational(9, 10), Rational(1, 100), n, 1}};
    return certificate;
}

}  // namespace

TEST_CASE("the invariant is drawn beside its factors, with the bound that is proved") {
    const std::string svg = adiabatic_svg(sample(AdiabaticClaim::run, 20));
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<circle class=\"bounce\"") == 21);
    CHECK(count_of(svg, "<path class=\"speed\"") == 1);
    CHECK(count_of(svg, "<path class=\"invariant\"") == 2);
    CHECK(count_of(svg, "<line class=\"bound\"") == 2 + 1);
    CHECK_THAT(svg, Contains("5.1204 delta") && !Contains("nan") && !Contains("class=\"behind\""));
    CHECK(adiabatic_svg(sample(AdiabaticClaim::run, 20)) == svg);
}

TEST_CASE("a scattering ends behind its last collision, and its unit is the root of delta") {
    const std::string svg = adiabatic_svg(sample(AdiabaticClaim::scattering, 20));
    CHECK(count_of(svg, "<circle class=\"behind\"") == 1);
    CHECK_THAT(svg, Contains("\xe2\x88\x9a"
                             "delta"));
}

TEST_CASE("without a proved bound there is no line for it") {
    AdiabaticCertificate certificate = sample(AdiabaticClaim::printed, 3);
    certificate.bounds.clear();
    const std::string svg = adiabatic_svg(certificate);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "class=\"bound\"") == 0);
}

TEST_CASE("single bounces, and orbits that are too long or come to an end, have no picture") {
    CHECK_THROWS_WITH(adiabatic_svg(sample(AdiabaticClaim::bounce, 1)), Contains("thm3.3"));
    CHECK_THROWS_AS(adiabatic_svg(sample(AdiabaticClaim::run, most_plotted_bounces + 1)), InputError);
    CHECK_THROWS_AS(adiabatic_svg(sample(AdiabaticClaim::run, most_plotted_bounces)), InputError);
}
