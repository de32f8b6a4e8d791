// What the law says of single ratios and what covers prove of them, at hundreds of ratios.
#include <catch2/catch.hpp>
#include <random>

#include "collisions/piece.hpp"
#include "law/at_ratio.hpp"
#include "law/constants.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::law;

namespace {

/// The maximum by cover and witness, which use no law.
long proved(const Rational& q) {
    const Piece piece = prove_single(q, piece_options(Scene::dumbbell, Section::turning)).piece;
    REQUIRE(piece.upper);
    REQUIRE(*piece.upper == piece.lower);
    return piece.lower;
}

AtRatio at_ratio(const Rational& q) {
    static const auto steps = read_steps(DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    return law_at(q, steps);
}

void check_agreement(const Rational& q) {
    const AtRatio at = at_ratio(q);
    const long n = proved(q);
    CAPTURE(q, n, at.lower.str(), at.upper.str());
    CHECK(at.lower <= Integer(n));
    CHECK(Integer(n) <= at.upper);
}

}  // namespace

TEST_CASE("the law agrees with covers at ratios of all sizes") {
    for (const char* q : {"1", "1.001", "2", "4.6", "4.61", "10", "62", "62.7", "62.72", "63", "100", "457.5",
                          "1000", "12345.678", "1e5", "1e6", "1032800", "1032810", "1.04e6"}) {
        check_agreement(parse_rational(q));
    }
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> exponent(6, 12);
    for (int i = 0; i < 150; ++i) {
        check_agreement(exact(std::pow(10, exponent(random))));
    }
}

TEST_CASE("the law agrees with covers next to steps, and decides all but a share q^(-1/2) ln q of each") {
    std::mt19937_64 random(21);
    std::uniform_int_distribution<long> steps(903, 3000);
    const PrecisionScope scope(256);
    const Constants constants;
    for (int i = 0; i < 6; ++i) {
        const long n = steps(random);
        const BigInterval delta = delta_bounds(Integer(n));
        const Rational width = exact_hi(delta) - exact_lo(delta), C = exact_lo(constants.C);
        for (const int side : {-2, -1, 0, 1, 2}) {
            const Rational middle = (exact_lo(delta) + exact_hi(delta)) / 2;
            const Rational root = (Rational(n - 2) + middle + width * Rational(51 * side, 100)) / C;
            const Rational q = exact((root * root).convert_to<double>());
            check_agreement(q);
            const AtRatio at = at_ratio(q);
            CAPTURE(n, side);
            CHECK((at.lower == at.upper) == (side != 0));
            CHECK(at.step == Integer(n));
        }
    }
}

TEST_CASE("the law agrees with covers a hundredth of a step away from steps, up to N = 10^6") {
    std::mt19937_64 random(22);
    std::uniform_real_distribution<double> exponent(4, 6);
    const PrecisionScope scope(256);
    const Rational C = exact_lo(Constants().C);
    for (int i = 0; i < 25; ++i) {
        const auto n = std::lround(std::pow(10, exponent(random)));
        const Rational step = Rational(n - 2) + exact_lo(delta_bounds(Integer(n)));
        for (const int side : {-1, 1}) {
            const Rational root = (step + Rational(side, 100)) / C;
            const Rational q = exact((root * root).convert_to<double>());
            check_agreement(q);
            CAPTURE(n, side);
            CHECK(at_ratio(q).lower == Integer(side < 0 ? n - 1 : n));
        }
    }
}
