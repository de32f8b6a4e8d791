#include "pictures/body_map.hpp"

#include "catch.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using namespace dumbbell;
using namespace dumbbell::pictures;

namespace {

collisions::Certificate bodies(const Rational& rho, const Rational& q_lo, const Rational& q_hi, long lower,
                               long upper) {
    collisions::Certificate certificate;
    certificate.system.section = collisions::Section::body;
    certificate.system.rho = rho;
    collisions::Piece piece;
    piece.q_lo = q_lo;
    piece.q_hi = q_hi;
    piece.lower = lower;
    piece.upper = upper;
    certificate.pieces.push_back(piece);
    return certificate;
}

}  // namespace

TEST_CASE("a map of bodies has a disc for each, a strip for a range, and hatches what is not decided") {
    const std::string svg = body_map_svg(
        {bodies(1, 4, 4, 4, 4), bodies(Rational(1, 2), 9, 10, 5, 5), bodies(Rational(3, 4), 9, 9, 4, 9)});
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<circle class=\"n4\"") == 1);
    CHECK(count_of(svg, "<circle class=\"hatched\"") == 1);
    CHECK(count_of(svg, "<rect class=\"n5\"") == 2);  // and in the legend
    CHECK_THAT(svg, Contains("N = 4") && Contains("N = 5") && Contains("not decided") && Contains("coin"));
    CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
}
