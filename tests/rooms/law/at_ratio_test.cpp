#include "law/at_ratio.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <tuple>

#include "base/error.hpp"
#include "collisions/critical.hpp"
#include "collisions/piece.hpp"
#include "law/constants.hpp"
#include "law/critical.hpp"

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

TEST_CASE("below the theorem's ratios the law is that of its certificate's steps") {
    for (const auto& [text, lower, upper] :
         std::vector<std::tuple<const char*, long, long>>{{"1", 2, 2},
                                                          {"1.000000000000000000000000000001", 3, 3},
                                                          {"32/7", 3, 3},
                                                          {"4.6", 3, 4},
                                                          {"24/5", 4, 4},
                                                          {"10", 4, 4},
                                                          {"62.6", 8, 8},
                                                          {"62.7", 8, 9},
                                                          {"62.75", 9, 9},
                                                          {"1032803", 901, 901},
                                                          {"1032804", 901, 902},
                                                          {"1032809.5", 902, 902}}) {
        CAPTURE(text);
        const AtRatio at = at_ratio(parse_rational(text));
        CHECK(at.lower == Integer(lower));
        CHECK(at.upper == Integer(upper));
        CHECK((at.lower == at.upper) == (exact_lo(at.past) >= 0 || exact_hi(at.past) <= 0));
    }
}

TEST_CASE("all steps of the shipped certificate are read, and nothing else as one") {
    const auto steps = read_steps(DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    REQUIRE(std::ssize(steps) == last_step - first_step + 1);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        CHECK(steps[i].below < steps[i].above);
        CHECK(steps[i].above < steps[i + 1].below);
    }
    CHECK_THROWS_AS(read_steps(DUMBBELL_PROJECT "/certificates/q-10.dbc"), InputError);
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

TEST_CASE("the law reaches as far as one can write ratios") {
    const AtRatio at = at_ratio(parse_rational("1e100"));
    CHECK(at.lower == at.upper);
    CHECK(at.lower.str() == "88559512945271391141202194891455767300579529460287");
    CHECK(width(at.past) < 1e-45);
    const AtRatio third = at_ratio(parse_rational("1e300") / 3);
    CHECK(third.lower == third.upper);
}

TEST_CASE("critical ratios by the law contain those of the orbits, and are as narrow as it says") {
    for (const long n : {903L, 904L, 2001L, 5002L}) {
        CAPTURE(n);
        const BigInterval by_law = critical_ratio(Integer(n));
        const auto by_orbit = enclose_critical_ratio(n, {.digits = 20});
        REQUIRE(by_orbit);
        CHECK(exact_lo(by_law) <= by_orbit->q_lo);
        CHECK(by_orbit->q_hi <= exact_hi(by_law));
        // delta is known to (0.063 ln q + 0.54) q^(-1/2), and q = (place/C)^2.
        const double q = approximate(by_law);
        CHECK(width(by_law) <= 2 / 0.8855 * (0.063 * std::log(q) + 0.55));
    }
}
