// What the law says of single ratios and what covers prove of them, at hundreds of ratios.
#include <cmath>
#include <random>
#include <tuple>

#include "catch.hpp"
#include "collisions/piece.hpp"
#include "law/at_ratio.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::law;

namespace {

/// The maximum by cover and witness, which use no law.
long proved(const Rational& q) {
    const Piece piece = prove_single(q, piece_options({})).piece;
    REQUIRE(piece.upper);
    REQUIRE(*piece.upper == piece.lower);
    return as_long(piece.lower);
}

const std::vector<StepEnds>& steps() {
    static const auto all = read_steps(DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    return all;
}
AtRatio at_ratio(const Rational& q) { return law_at(q, steps()); }

/// N by covers is among what the law says, which is one value or, next to a step, two. Returns N.
long check_agreement(const Rational& q, bool decided) {
    const AtRatio at = at_ratio(q);
    const long n = proved(q);
    CAPTURE(q, n, at.lower.str(), at.upper.str());
    CHECK(at.lower <= Integer(n));
    CHECK(Integer(n) <= at.upper);
    CHECK(at.upper - at.lower == Integer(decided ? 0 : 1));
    return n;
}

constexpr double C = 0.88559512945271391, c0 = 0.20581158954949560, kappa = 0.025524484895950447;

/// The mass ratio at which C sqrt q - (n - 2) is a bound of Theorem A, the upper or the lower one, and
/// `past` more.
Rational edge(long n, bool upper, double past) {
    long double root = static_cast<long double>(n) / C;
    for (int i = 0; i < 50; ++i) {
        const long double slack = 0.072L + 2.6L / std::sqrt(root), after = n % 2 == 0 ? 0.497L : 0.38L;
        const long double less = 2 * kappa * std::log(root) + after + (upper ? -slack : slack);
        root = (static_cast<long double>(n - 2) + c0 / std::sqrt(root) - less / root + past) / C;
    }
    return exact(static_cast<double>(root * root));
}

}  // namespace

TEST_CASE("the law agrees with covers at ratios of all sizes, and decides all but those next to steps") {
    for (const auto& [q, n, decided] : std::vector<std::tuple<const char*, long, bool>>{
             {"1", 2, true},           {"1.000001", 3, true},     {"8/7", 3, true},
             {"2", 3, true},           {"4.572", 3, false},       {"4.6", 3, false},
             {"4.61", 4, false},       {"4.799", 4, false},       {"10", 4, true},
             {"11", 4, true},          {"11.2", 4, false},        {"103/9", 5, true},
             {"62", 8, true},          {"62.6", 8, true},         {"62.7", 8, false},
             {"62.72", 9, false},      {"62.75", 9, true},        {"100", 10, true},
             {"457.5", 20, true},      {"1000", 29, true},        {"12345.678", 100, true},
             {"1e5", 282, true},       {"1e6", 887, true},        {"1032800", 901, true},
             {"1032803", 901, true},   {"1032804", 901, false},   {"1032804.5", 901, false},
             {"1032809.5", 902, true}, {"1032810", 902, true},    {"1035103", 902, true},
             {"1035105", 902, true},   {"1035105.5", 902, false}, {"1035105.9", 903, false},
             {"1035106", 903, true},   {"1.04e6", 905, true},     {"1.5e7", 3431, true},
             {"1e8", 8857, true}}) {
        CAPTURE(q);
        CHECK(check_agreement(parse_rational(q), decided) == n);
    }
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> exponent(6, 12);
    for (long i = 0; i < scaled(10); ++i) {
        const Rational q = exact(std::pow(10, exponent(random)));
        const AtRatio at = at_ratio(q);
        check_agreement(q, at.lower == at.upper);
    }
}

TEST_CASE("at the ends of a step of its certificate the law decides, and nearer to the step it does not") {
    for (const long n : {4L, 5L, 9L, 21L, 100L, 902L}) {
        const StepEnds& ends = steps().at(static_cast<std::size_t>(n - first_step));
        const Rational hair = (ends.above - ends.below) / 1000;
        CAPTURE(n);
        CHECK(check_agreement(ends.below, true) == n - 1);
        CHECK(check_agreement(ends.above, true) == n);
        check_agreement(ends.below + hair, false);
        check_agreement(ends.above - hair, false);
    }
}

TEST_CASE(
    "beyond its certificate's steps the law decides outside the bounds of Theorem A, not between them") {
    std::mt19937_64 random(21);
    std::uniform_int_distribution<long> later(904, 3000);
    for (const long n : {903L, later(random), later(random), later(random), later(random), 8308L}) {
        CAPTURE(n);
        CHECK(check_agreement(edge(n, false, -1e-6), true) == n - 1);
        CHECK(check_agreement(edge(n, true, 1e-6), true) == n);
        check_agreement(edge(n, false, 1e-9), false);
        check_agreement(edge(n, true, -1e-9), false);
        const Rational middle = (edge(n, false, 0) + edge(n, true, 0)) / 2;
        check_agreement(middle, false);
        CHECK(at_ratio(middle).step == Integer(n));
    }
}

TEST_CASE("the law agrees with covers a hundredth of a step away from steps, up to N = 10^6") {
    std::mt19937_64 random(22);
    std::uniform_real_distribution<double> exponent(4, 6);
    for (long i = 0; i < scaled(5); ++i) {
        const auto n = std::lround(std::pow(10, exponent(random)));
        CAPTURE(n);
        CHECK(check_agreement(edge(n, false, -0.01), true) == n - 1);
        CHECK(check_agreement(edge(n, true, 0.01), true) == n);
    }
}
