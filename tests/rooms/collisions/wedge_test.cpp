// The model wedges: what is proved is ceil(pi / gamma), the number that unfolding the straight wedge gives,
// here from the formula in 80 digits.
#include <algorithm>

#include "catch.hpp"
#include "collisions/certify.hpp"
#include "critical_ratio.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

// A straight line through the fan of reflected wedges of angle gamma = pi - 2 atan(sqrt q), measured in the
// kinetic metric, turns by less than pi: it crosses at most ceil(pi / gamma) walls, and some line does.
long unfolded(const Rational& q) {
    const Real turns = dumbbell_oracle::pi<Real>() / (dumbbell_oracle::pi<Real>() - 2 * atan(sqrt(real(q))));
    const Real whole = round(turns);
    // cot^2(pi/2m) is rational at m = 2 and 3 only: elsewhere no rational ratio of these tests is so close.
    const bool tie = abs(turns - whole) < Real("1e-65");
    REQUIRE(tie == (q == 1 || q == 3));
    return (tie ? whole : Real(ceil(turns))).convert_to<long>();
}

void check_scene(const Rational& q, Section section, long n) {
    CertifyRequest request;
    request.claim.range = {q, q};
    request.claim.system.section = section;
    const auto pieces = certify(request);
    REQUIRE(pieces.size() == 1);
    const Piece& piece = pieces.front().piece;
    CAPTURE(q, n, section == Section::hybrid);
    REQUIRE(piece.upper == n);
    REQUIRE(piece.lower == n);
    REQUIRE(piece.witness.has_value());
    REQUIRE(piece.witness->total() == n);
}

void check_both(const Rational& q) {
    const long n = unfolded(q);
    check_scene(q, Section::wedge, n);
    check_scene(q, Section::hybrid, n);
}

// Within 1e-75 (relative) of the ratio cot^2(pi/2m) at which pi / gamma = m.
Rational tie(long m) {
    const Real t = tan(dumbbell_oracle::pi<Real>() / (2 * m));
    return parse_rational(Real(1 / (t * t)).str(76, std::ios::fixed));
}

}  // namespace

TEST_CASE("the wedges have ceil(pi/gamma) collisions at ratios from 1 to 10,000") {
    Random choices(71);
    for (int i = 0; i < scaled(50); ++i) {
        check_both(exact(choices.log_uniform(1, 10'000)));
    }
}

TEST_CASE("the wedges are decided on both sides of ratios where pi/gamma is an integer") {
    for (const long m : steps({2, 3, 4, 5, 12}, {6, 7, 33, 64, 65, 100})) {
        for (const char* distance : {"1e-3", "1e-9", "1e-15", "1e-30"}) {
            CAPTURE(m, distance);
            const Rational below = tie(m) * (1 - parse_rational(distance));
            const Rational above = tie(m) * (1 + parse_rational(distance));
            if (below >= 1) {
                CHECK(unfolded(below) == m);
                check_both(below);
            }
            CHECK(unfolded(above) == m + 1);
            check_both(above);
        }
    }
}

TEST_CASE("the exact ties are decided, two collisions at equal masses and three at ratio 3") {
    CHECK(unfolded(1) == 2);
    CHECK(unfolded(3) == 3);
    check_both(1);
    check_both(3);
}

TEST_CASE("over ranges of ratios the wedges have the unfolded number at both ends of every exact piece") {
    for (const Section section : {Section::wedge, Section::hybrid}) {
        CertifyRequest request;
        request.claim.range.lo = 1;
        request.claim.range.hi = 100;
        request.claim.system.section = section;
        const auto pieces = certify(request);
        CHECK(undecided_share(pieces) < Rational(1, 10000));
        for (const ProvedPiece& proved : pieces) {
            const Piece& piece = proved.piece;
            CAPTURE(piece.q_lo, piece.q_hi);
            REQUIRE(piece.upper.has_value());
            CHECK(*piece.upper - piece.lower <= 1);
            CHECK(unfolded(piece.q_lo) == piece.lower);
            CHECK(unfolded(piece.q_hi) == *piece.upper);
        }
    }
}
