#include "arith/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace dumbbell {
namespace {

// Kernels on |y| <= 0.79 (a little more than pi/4): Taylor polynomials with coefficients rounded to double, z
// = y^2.
//
// Let u = 2^-53 (L14). Error of sin_kernel against sin y, relative to |y| (z <= 0.625):
//   remainder |y|^19/19!                                    <= 2e-19 |y|  < 0.002 u |y|
//   Horner sum S (|S| <= 1/6): coefficient, last product and last addition; the inner terms are below 0.01
//                                                           <= 0.37 u, times z: 0.24 u |y|
//   the product y z S: three roundings on at most 0.105 |y| <= 0.32 u |y|
//   the final addition                                      <= 1.0 u |y|
// in all < 1.6 u |y| <= 1.8 u |sin y|.
// Error of cos_kernel against cos y: remainder y^20/20! < 0.0001 u; h = z/2 is exact after z, whose rounding
// gives 0.32 u; the term z^2 C (<= 0.017) 0.07 u; w = 1 - h is corrected by the exact (1 - w) - h, adding the
// two corrections 0.02 u; the final addition 0.5 u. In all < 1 u <= 1.5 u cos y.
double sin_kernel(double y) noexcept {
    const double z = y * y;
    const double s =
        -1.0 / 6 +
        z * (1.0 / 120 +
             z * (-1.0 / 5040 +
                  z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                           z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0 +
                                                                          z * (1.0 / 355687428096000.0)))))));
    return y + y * z * s;
}

double cos_kernel(double y) noexcept {
    const double z = y * y;
    const double c =
        1.0 / 24 +
        z * (-1.0 / 720 +
             z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                     z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 +
                                                                   z * (1.0 / 20922789888000.0 +
                                                                        z * (-1.0 / 6402373705728000.0)))))));
    const double h = 0.5 * z;
    const double w = 1.0 - h;
    return w + (((1.0 - w) - h) + z * z * c);
}

constexpr double half_pi_hi = 0x1.921fb54442d18p+0;
constexpr double half_pi_lo = 0x1.1a62633145c07p-54;  // pi/2 - half_pi_hi, error < 2^-108
constexpr double quarter_pi = 0x1.921fb54442d18p-1;
constexpr double pad = 0x1p-50;

// What is proved, relative, in units of u: by hand in L14, and by tool, from the text of this very file, in
// proofs/kernels.
constexpr double reach = 0.79;          // the kernels' greatest argument
constexpr double sine_error = 1.8;      // of sin_kernel
constexpr double cosine_error = 1.5;    // of cos_kernel
constexpr double argument_error = 1.5;  // of y = pi/2 - x as computed
constexpr double guess_error = 4.0;     // of guess_sin_cos
static_assert(half_pi_hi - quarter_pi < reach);
static_assert(sine_error + argument_error < guess_error && cosine_error + argument_error < guess_error);
static_assert(guess_error + 2 < pad * 0x1p53);

/// [v - p, v + p], p > 2^-50 |v|. On [0, pi/2] the guesses below differ from the true value t by at most 4 u
/// |t|: kernel 1.8 u, plus, above pi/4, the error of y = pi/2 - x. half_pi_hi - x is exact (Sterbenz), adding
/// half_pi_lo rounds once and half_pi_lo is off by less than 2^-108, at most 2^-54 |y| as |y| >= 2^-54: in
/// all 1.5 u |y|, which moves sin y by at most 1.5 u and cos y by at most 1.5 u y^2, relatively. 4 u |t|
/// < 4.01 u |v|, the rounding of v -+ 2^-50 |v| is at most 1.01 u |v|, and 2^-50 = 8 u. The step to the
/// neighbour covers subnormal v, where the product underflows: there sin y rounds to y or its neighbour.
Interval widened(double v) noexcept {
    const double p = std::abs(v) * pad;
    return {next_down(v - p), next_up(v + p)};
}

/// The enclosures of sin and cos of one double in [0, pi/2], clipped to [0, 1].
SinCos<Interval> first_quadrant(double x) noexcept {
    const SinCosGuess v = guess_sin_cos(x);
    const Interval s = widened(v.sin);
    const Interval c = widened(v.cos);
    return {{std::max(0.0, s.lo()), std::min(1.0, s.hi())}, {std::max(0.0, c.lo()), std::min(1.0, c.hi())}};
}

/// The enclosures at one double of any size: x = k pi/2 + y with y in a small interval around [-pi/4, pi/4].
SinCos<Interval> at_point(double x) {
    if (x >= 0 && x <= half_pi_hi) {
        return first_quadrant(x);
    }
    if (!(std::abs(x) <= 0x1p20)) {
        return {{-1, 1}, {-1, 1}};
    }
    const double k = std::nearbyint(x / half_pi_hi);
    const Interval y = Interval(x) - Interval(k) * half_pi<Interval>();
    // |y| <= pi/4 + 2^-29: sine is increasing there, and cosine lies between its values at the ends and 1.
    const auto signed_sine = [](double v) {
        const Interval s = first_quadrant(std::abs(v)).sin;
        return v < 0 ? -s : s;
    };
    const Interval s{signed_sine(y.lo()).lo(), signed_sine(y.hi()).hi()};
    const Interval cl = first_quadrant(std::abs(y.lo())).cos;
    const Interval ch = first_quadrant(std::abs(y.hi())).cos;
    const bool straddles = y.lo() <= 0 && y.hi() >= 0;
    const Interval c{std::min(cl.lo(), ch.lo()), straddles ? 1.0 : std::max(cl.hi(), ch.hi())};
    switch (static_cast<long>(k) & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

/// Whether X may contain a point offset + 2 pi j, j an integer. Never a wrong "no".
bool may_contain(const Interval& x, const Interval& offset) {
    const Interval turns = (x - offset) / (Interval(2) * pi<Interval>());
    return std::floor(turns.lo()) != std::floor(turns.hi()) || turns.lo() == std::floor(turns.lo());
}

/// The range over X from the enclosures at its ends and the extrema (+1 at `top`, -1 at `top` + pi, mod 2 pi)
/// inside.
Interval over_range(const Interval& x, const Interval& at_lo, const Interval& at_hi, const Interval& top) {
    const Interval ends = hull(at_lo, at_hi);
    const double hi = may_contain(x, top) ? 1.0 : std::min(1.0, ends.hi());
    const double lo = may_contain(x, top + pi<Interval>()) ? -1.0 : std::max(-1.0, ends.lo());
    return {lo, hi};
}

}  // namespace

SinCosGuess guess_sin_cos(double x) noexcept {
    if (x <= quarter_pi) {
        return {sin_kernel(x), cos_kernel(x)};
    }
    const double y = (half_pi_hi - x) + half_pi_lo;
    return {cos_kernel(y), sin_kernel(y)};
}

SinCos<Interval> sin_cos(const Interval& x) {
    if (x.lo() == x.hi()) {
        return at_point(x.lo());
    }
    if (x.lo() >= 0 && x.hi() <= half_pi_hi) {
        const auto a = first_quadrant(x.lo());
        const auto b = first_quadrant(x.hi());
        return {{a.sin.lo(), b.sin.hi()}, {b.cos.lo(), a.cos.hi()}};
    }
    if (!(x.hi() - x.lo() < 6)) {  // more than a turn is near; NaN too
        return {{-1, 1}, {-1, 1}};
    }
    const auto a = at_point(x.lo());
    const auto b = at_point(x.hi());
    return {over_range(x, a.sin, b.sin, half_pi<Interval>()), over_range(x, a.cos, b.cos, Interval(0))};
}

Interval sin(const Interval& x) { return sin_cos(x).sin; }
Interval cos(const Interval& x) { return sin_cos(x).cos; }

namespace {

/// A lower bound of asin(v), v in [-1, 1]: a point y of [-pi/2, pi/2] with sin y <= v certified; sine
/// increases there.
double asin_lower(double v) {
    const double bottom = -half_pi<Interval>().hi();
    const double guess = std::asin(v);  // a guess only
    for (double step = std::abs(guess) * 0x1p-52 + 0x1p-1060;; step *= 2) {
        const double y = guess - step;
        if (!(y > -half_pi_hi)) {
            return bottom;
        }
        if (at_point(y).sin.hi() <= v) {
            return y;
        }
    }
}

}  // namespace

Interval asin(const Interval& x) {
    const double lo = std::max(-1.0, x.lo());
    const double hi = std::min(1.0, x.hi());
    return {asin_lower(lo), -asin_lower(-hi)};
}

}  // namespace dumbbell
