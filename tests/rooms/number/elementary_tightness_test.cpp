// How good the elementary functions are: the proved error bound of the kernels, and constants measured once
// that later changes must keep.
#include <cmath>

#include "angles.hpp"
#include "catch.hpp"
#include "number/elementary.hpp"
#include "random.hpp"
#include "scale.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

constexpr double half_pi_down = 0x1.921fb54442d18p+0;

/// |guess - exact| in units of 2^-53 |exact|; EXACT is changed.
double error_in_units(mpfr_ptr exact, double guess) {
    static thread_local Mpfr difference(60, 0);
    mpfr_sub_d(difference, exact, guess, MPFR_RNDA);
    if (mpfr_zero_p(static_cast<mpfr_ptr>(difference))) {
        return 0;
    }
    mpfr_div(difference, difference, exact, MPFR_RNDA);
    return std::abs(mpfr_get_d(difference, MPFR_RNDA)) * 0x1p53;
}

double point_of_first_quadrant(Random& random) {
    switch (random.below(5)) {
        case 0:
            return random.scaled(0x1p-1074, 1);
        case 1:
            return std::clamp(half_pi_down - random.scaled(0x1p-52, 1), 0.0, half_pi_down);
        case 2:
            return 0x1.921fb54442d18p-1 + random.sign() * random.scaled(0x1p-53, 0x1p-4);  // around pi/4
        default:
            return random.uniform(0, half_pi_down);
    }
}

}  // namespace

TEST_CASE("guess_sin_cos keeps its proved bound of 4 units at points of [0, pi/2]") {
    Random random(31);
    Mpfr argument;
    Mpfr sine(100, 0);
    Mpfr cosine(100, 0);
    double worst_sine = 0;
    double worst_cosine = 0;
    for (long i = 0; i < scaled(50'000); ++i) {
        const double x = i < 4 ? neighbour(i < 2 ? 0.0 : half_pi_down, i % 2 == 0 ? 0 : (i < 2 ? 1 : -1))
                               : point_of_first_quadrant(random);
        const SinCosGuess guess = guess_sin_cos(x);
        mpfr_set_d(argument, x, MPFR_RNDN);
        mpfr_sin_cos(sine, cosine, argument, MPFR_RNDN);
        const double sine_error = x == 0 ? std::abs(guess.sin) : error_in_units(sine, guess.sin);
        const double cosine_error = error_in_units(cosine, guess.cos);
        if (!(sine_error <= 4 && cosine_error <= 4)) {
            FAIL(say("x =", x, "sin", guess.sin, "off by", sine_error, "cos", guess.cos, "off by",
                     cosine_error));
        }
        worst_sine = std::max(worst_sine, sine_error);
        worst_cosine = std::max(worst_cosine, cosine_error);
    }
    WARN("worst errors in units of 2^-53: sin " << worst_sine << ", cos " << worst_cosine);
    CHECK(worst_sine > 0.5);  // else the comparison measures nothing
}

TEST_CASE("The kernels on [0, pi/4] keep the errors measured when they were written") {
    Random random(35);
    double worst_sine = 0;
    double worst_cosine = 0;
    Mpfr sine(100, 0);
    Mpfr cosine(100, 0);
    for (long i = 0; i < scaled(20'000); ++i) {
        const double x = random.uniform(random.coin() ? 0.7 : 0, 0x1.921fb54442d18p-1);
        Mpfr argument(x);
        mpfr_sin_cos(sine, cosine, argument, MPFR_RNDN);
        const SinCosGuess guess = guess_sin_cos(x);
        worst_sine = std::max(worst_sine, error_in_units(sine, guess.sin));
        worst_cosine = std::max(worst_cosine, error_in_units(cosine, guess.cos));
    }
    CHECK(worst_sine < 1.2);
    CHECK(worst_cosine < 1.1);
}

TEST_CASE("At a point of [0, pi/2] the enclosure is from two doubles below the guess to two above") {
    Random random(36);
    const auto around = [](double v) {
        return Interval(v == 0 ? 0 : std::max(0.0, next_down(next_down(v))),
                        std::min(1.0, next_up(next_up(v))));
    };
    for (int i = 0; i < 20'000; ++i) {
        const double x = i < 2 ? i * half_pi_down : point_of_first_quadrant(random);
        const SinCosGuess guess = guess_sin_cos(x);
        const Interval s = around(guess.sin);
        const Interval c = around(guess.cos);
        const auto ours = sin_cos(Interval(x));
        if (!is(ours.sin, s.lo(), s.hi()) || !is(ours.cos, c.lo(), c.hi()) || s.hi() - s.lo() > 0x1p-51 ||
            c.hi() - c.lo() > 0x1p-51) {
            FAIL(say("x =", x, "sin", ours.sin, "cos", ours.cos));
        }
    }
}

TEST_CASE("Beside a point sine and cosine are enclosed, and as wide as the proof asks for") {
    Random random(37);
    const auto has_room = [](const Interval& y, double v) {
        return y.lo() <= v * (1 - 5.4 * 0x1p-53) && y.hi() >= v * (1 + 5.4 * 0x1p-53) &&
               width(y) <= v * 0x1.8p-49;
    };
    for (long i = 0; i < scaled(20'000); ++i) {
        const double z = std::max(0x1p-900, point_of_first_quadrant(random));
        const SinCosGuess at = guess_sin_cos(z);
        const double reach = 0x1p-8 * std::min({at.sin, at.cos, 0x1p-5});
        const double x = z + random.sign() * reach * (random.coin() ? 1 : random.uniform(0, 1));
        if (std::abs(x - z) > reach) {
            continue;
        }
        const auto ours = sin_cos_beside(at, x - z);
        if (!encloses(ours.sin, at_point(mpfr_sin, x)) || !encloses(ours.cos, at_point(mpfr_cos, x)) ||
            !has_room(ours.sin, approximate(ours.sin)) || !has_room(ours.cos, approximate(ours.cos))) {
            FAIL(say("z =", z, "x =", x, "sin", ours.sin, "cos", ours.cos));
        }
    }
}

TEST_CASE("On [0, pi/2] sin and cos are at most 3 doubles too wide") {
    Random random(32);
    std::int64_t worst = 0;
    for (long i = 0; i < scaled(20'000); ++i) {
        const double a = point_of_first_quadrant(random);
        const double b = random.coin() ? a : point_of_first_quadrant(random);
        const Interval x(std::min(a, b), std::max(a, b));
        const auto ours = sin_cos(x);
        const std::int64_t sine =
            excess(ours.sin, {at_point(mpfr_sin, x.lo()).lo, at_point(mpfr_sin, x.hi()).hi});
        const std::int64_t cosine =
            excess(ours.cos, {at_point(mpfr_cos, x.hi()).lo, at_point(mpfr_cos, x.lo()).hi});
        if (sine > 3 || cosine > 3) {
            FAIL(say("x =", x, "excess", sine, cosine));
        }
        worst = std::max({worst, sine, cosine});
    }
    WARN("greatest excess on [0, pi/2] in doubles: " << worst);
}

TEST_CASE("Up to 2^20 sin and cos are as wide as the pad of a reduced argument, beside their zeros too") {
    Random random(33);
    const auto is_tight = [](double x, const Interval& y) {
        return width(y) <= 0x1.41p-50 * std::abs(approximate(y)) + std::abs(x) * 0x1p-115 + 0x1p-1070;
    };
    for (int i = 0; i < 50'000; ++i) {
        const double x = random.coin() ? near_quarter_turn(random) : random.sign() * random.scaled(1, 0x1p20);
        const auto ours = sin_cos(Interval(x));
        if (!is_tight(x, ours.sin) || !is_tight(x, ours.cos)) {
            FAIL(say("x =", x, "sin", ours.sin, "cos", ours.cos));
        }
    }
}

TEST_CASE("asin is as wide as sine's enclosure allows") {
    Random random(34);
    double worst = 0;
    for (int i = 0; i < 50'000; ++i) {
        const double v =
            random.coin() ? random.sign() * (1 - random.scaled(0x1p-53, 1)) : random.uniform(-1, 1);
        const double cosine = std::sqrt((1 - v) * (1 + v));
        // The pad of 2^-50 moves asin by 2^-50 / cos, and by sqrt(2^-50) where the cosine is smaller.
        const double natural = 0x1p-50 / std::max(cosine, 0x1p-25);
        const double ratio = width(asin(Interval(v))) / natural;
        if (!(ratio <= 16)) {
            FAIL(say("v =", v, "asin", asin(Interval(v)), "wider than natural by", ratio));
        }
        worst = std::max(worst, ratio);
    }
    WARN("greatest width of asin in units of 2^-50 / cos: " << worst);
}

TEST_CASE("The arcsine of a tiny number, and ranges without an extremum, have tight enclosures") {
    CHECK(width(asin(Interval(1e-100))) < 1e-113);
    CHECK(sin(Interval(1, 2)).lo() > 0.84);
    CHECK(sin(Interval(4.6, 4.8)).hi() < -0.99);
    CHECK(cos(Interval(3, 3.3)).hi() < -0.98);
    CHECK(cos(Interval(6.1, 6.5)).lo() > 0.97);
    CHECK(cos(Interval(0.3, 5.9)).hi() < 0.96);
}
