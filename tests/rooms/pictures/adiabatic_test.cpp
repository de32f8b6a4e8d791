#include "pictures/adiabatic.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/pictures/xml.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;
using dumbbell::adiabatic::Claim;
using namespace dumbbell_test;

namespace {

dumbbell::adiabatic::Certificate sample(Claim claim, long n) {
    dumbbell::adiabatic::Certificate certificate;
    certificate.hypotheses.claim = claim;
    certificate.bounds = {Rational(51204, 10000)};
    certificate.attained = {{Rational(9, 10), Rational(9, 10), Rational(1, 100), n, 1}};
    return certificate;
}

}  // namespace

TEST_CASE("the invariant is drawn next to its factors, with the bound that is proved") {
    const std::string svg = adiabatic_svg(sample(Claim::run, 20));
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<circle class=\"bounce\"") == 21);
    CHECK(count_of(svg, "<path class=\"speed\"") == 1);
    CHECK(count_of(svg, "<path class=\"invariant\"") == 2);
    CHECK(count_of(svg, "<line class=\"bound\"") == 2 + 1);
    CHECK_THAT(svg, Contains("5.1204 delta") && !Contains("nan") && !Contains("class=\"after\""));
    CHECK(adiabatic_svg(sample(Claim::run, 20)) == svg);
}

TEST_CASE(
    "a scattering ends after its last collision, its curve goes there, and its unit is the root of delta") {
    const std::string svg = adiabatic_svg(sample(Claim::scattering, 20));
    CHECK(count_of(svg, "<circle class=\"after\"") == 1);
    CHECK_THAT(svg, Contains("\xe2\x88\x9a"
                             "delta") &&
                        Contains("ring: after the last one"));
    const std::size_t at = svg.rfind("<path class=\"invariant\"");
    const std::string path = svg.substr(at, svg.find("/>", at) - at);
    CHECK(count_of(path, "L") == 21);
    const std::size_t ring = svg.find("<circle class=\"after\" cx=\"") + 26;
    const std::string x = svg.substr(ring, svg.find('"', ring) - ring);
    CHECK_THAT(path, Contains("L" + x + " "));
}

TEST_CASE("a bound far outside is told in words") {
    dumbbell::adiabatic::Certificate certificate = sample(Claim::run, 20);
    certificate.bounds = {Rational(100)};
    const std::string far = adiabatic_svg(certificate);
    CHECK(well_formed(far));
    CHECK(count_of(far, "class=\"bound\"") == 0);
    CHECK_THAT(far, Contains("proved for all orbits: \xc2\xb1"
                             "100 delta"));
}

TEST_CASE("an orbit of a few collisions has no curve: refused, with what shows it") {
    CHECK_THROWS_WITH(adiabatic_svg(sample(Claim::scattering, 1)), Contains("has 2: dumbbell report"));
}

TEST_CASE("single bounces, and orbits that are too long or come to an end, have no picture") {
    CHECK_THROWS_WITH(adiabatic_svg(sample(Claim::bounce, 1)), Contains("thm3.3"));
    CHECK_THROWS_AS(adiabatic_svg(sample(Claim::run, most_plotted_bounces + 1)), InputError);
    CHECK_THROWS_AS(adiabatic_svg(sample(Claim::run, most_plotted_bounces)), InputError);
}
