#include "adiabatic/writer.hpp"

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;

namespace {

Certificate small_run() {
    Certificate certificate;
    certificate.generator = {"dumbbell", "0.1.0"};
    certificate.hypotheses.delta = {Rational(1, 100), Rational(1, 100)};
    certificate.hypotheses.heights = {Rational(0), Rational(9, 10)};
    certificate.hypotheses.margin = Rational(3, 10);
    certificate.bounds = {Rational(17)};
    const Node outside{std::nullopt, true, 0}, bound{std::nullopt, false, 0}, second{std::nullopt, false, 1};
    certificate.classes = {
        {Rational(6, 5), {{Rational(1), Rational(2)}, {Rational(1, 4), Rational(0)}}, {bound}}};
    certificate.tree = {{Axis::v, false, 0}, outside, second};
    certificate.attained = {{Rational(1, 2), Rational(1), Rational(1, 100), 63, Rational(31, 2)}};
    return certificate;
}

}  // namespace

TEST_CASE("An adiabatic certificate is spelled as docs/reference/format-adiabatic.md says") {
    const std::string text = render(small_run()).text;
    CHECK(text.substr(0, text.find("sha256")) == R"(dumbbell-certificate 1
generator dumbbell 0.1.0
lemmas 1
scene dumbbell
section none
claim adiabatic-run
delta 1/100 1/100
heights 0/1 9/10
margin 3/10
bits 53
bound 17/1
classes 1
class 6/5 2
cell 1/1 2/1
cell 1/4 0/1
bound
end
split v
outside
bound 1
attained 1/2 1/1 1/100 63 31/2
total split 1
total bound 2
total outside 1
)");
}

TEST_CASE("The claims differ in their lines") {
    Certificate certificate = small_run();
    certificate.hypotheses.claim = Claim::scattering;
    CHECK_THAT(render(certificate).text,
               Contains("claim adiabatic-scattering\ndelta 1/100 1/100\nmargin 3/10\nbits"));
    certificate.hypotheses.claim = Claim::bounce;
    certificate.bounds = {Rational(2), Rational(12)};
    CHECK_THROWS_AS(render(certificate), BrokenInvariant);  // an orbit is missing
    certificate.attained.push_back(certificate.attained[0]);
    CHECK_THAT(render(certificate).text,
               Contains("margin 3/10\nexponent 8\nbits 53\nbound 2/1 12/1\nsplit v\noutside\nbound\n"));
}

TEST_CASE("A tree that is not complete, or goes on, is never written") {
    Certificate certificate = small_run();
    certificate.tree.pop_back();
    CHECK_THROWS_AS(render(certificate), BrokenInvariant);
    certificate = small_run();
    certificate.tree.push_back({});
    CHECK_THROWS_AS(render(certificate), BrokenInvariant);
    certificate = small_run();
    certificate.classes[0].tree.clear();
    CHECK_THROWS_AS(render(certificate), BrokenInvariant);
}
