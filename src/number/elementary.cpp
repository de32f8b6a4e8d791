#include "number/elementary.hpp"

#include <algorithm>
#include <cmath>

#include "number/sine_kernel.hpp"

namespace dumbbell {
namespace {

constexpr double pad = 0x1p-50;

// What is proved, relative, in units of u: by hand in L14, and by tool, from the text of this very file, in
// proofs/kernels.
constexpr double reach = 0.79;          // the kernels' greatest argument
constexpr double sine_error = 1.8;      // of sin_kernel
constexpr double cosine_error = 1.5;    // of cos_kernel
constexpr double argument_error = 1.5;  // of y = pi/2 - x as computed
constexpr double guess_error = 4.0;     // of guess_sin_cos
constexpr double moved_error = 5.4;     // of `moved`, from there (L63 (b))
static_assert(half_pi_hi - quarter_pi < reach);
static_assert(sine_error + argument_error < guess_error && cosine_error + argument_error < guess_error);
static_assert(moved_error + 2 < pad * 0x1p53);

/// What sin_kernel or cos_kernel computes as v on the way of guess_sin_cos lies between the doubles two below
/// v and two above (L63 (a)).
Interval two_doubles_around(double v) noexcept { return with_neighbours(with_neighbours(Interval(v))); }

/// [v - p, v + p] and the doubles beyond, p = 2^-50 |v|: what is off from v by moved_error (L63 (b)), or less
/// (L14 (c)).
Interval widened(double v) noexcept {
    const double p = std::abs(v) * pad;
    return {next_down(v - p), next_up(v + p)};
}

/// The enclosures of sin and cos of one double in [0, pi/2], clipped to [0, 1].
SinCos<Interval> first_quadrant(double x) noexcept {
    const SinCosGuess v = guess_sin_cos(x);
    const Interval s = two_doubles_around(v.sin);
    const Interval c = two_doubles_around(v.cos);
    return {{std::max(0.0, s.lo()), std::min(1.0, s.hi())}, {std::max(0.0, c.lo()), std::min(1.0, c.hi())}};
}

constexpr double farthest = 0x1p20;

/// x = k pi/2 + t for a double of at most `farthest` in size: t is off from y by at most a rounding of y and
/// `rest` (L14 (e)).
struct Reduced {
    long k;
    double y;
    double rest;
};

Reduced reduced(double x) noexcept {
    const double k = std::nearbyint(x / half_pi_hi);
    const double d = x - k * half_pi_first;
    const double s = d - k * half_pi_second;
    return {static_cast<long>(k), s + (((d - s) - k * half_pi_second) - k * half_pi_third),
            std::abs(k) * 0x1p-116};
}

/// [-1, 1] and less: what a kernel computes as v from such a y (L14 (e)).
Interval around(double v, double rest) noexcept {
    const double p = std::abs(v) * 0x1p-51 + (rest + 0x1p-1074);
    return {std::max(-1.0, v - p), std::min(1.0, v + p)};
}

SinCos<Interval> at_reduced(const Reduced& x) noexcept {
    const Interval s = around(sin_kernel(x.y), x.rest);
    const Interval c = around(cos_kernel(x.y), x.rest);
    switch (x.k & 3) {
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

/// The ranges from one double to another that is less than a turn ahead, from those at its ends and the
/// extrema between: at the multiples of pi/2 from `first` to `last`.
SinCos<Interval> over_range(const Reduced& lo, const Reduced& hi) noexcept {
    const long first = lo.y > lo.rest ? lo.k + 1 : lo.k;
    const long last = hi.y < -hi.rest ? hi.k - 1 : hi.k;
    const auto with_extrema = [&](const Interval& ends, long top) {
        const auto has = [&](long k) { return first + ((k - first) & 3) <= last; };
        return Interval(has(top + 2) ? -1 : ends.lo(), has(top) ? 1 : ends.hi());
    };
    const SinCos<Interval> a = at_reduced(lo);
    const SinCos<Interval> b = at_reduced(hi);
    return {with_extrema(hull(a.sin, b.sin), 1), with_extrema(hull(a.cos, b.cos), 0)};
}

}  // namespace

SinCosGuess guess_sin_cos(double x) noexcept {
    const bool near = x <= quarter_pi;
    const double y = near ? x : (half_pi_hi - x) + half_pi_lo;
    const double s = sin_kernel(y);
    const double c = cos_kernel(y);
    return near ? SinCosGuess{s, c} : SinCosGuess{c, s};
}

SinCos<Interval> sin_cos_beside(const SinCosGuess& at, double shift) noexcept {
    const SinCosGuess v = moved(at, shift);
    return {widened(v.sin), widened(v.cos)};
}

SinCos<Interval> sin_cos(const Interval& x) {
    const bool is_thin = x.lo() == x.hi();
    if (x.lo() >= 0 && x.hi() <= half_pi_hi) {
        const auto a = first_quadrant(x.lo());
        const auto b = is_thin ? a : first_quadrant(x.hi());
        return {{a.sin.lo(), b.sin.hi()}, {b.cos.lo(), a.cos.hi()}};
    }
    // More than a turn is near, or too far out; NaN too.
    if (!(x.hi() - x.lo() < 6 && x.lo() >= -farthest && x.hi() <= farthest)) {
        return {{-1, 1}, {-1, 1}};
    }
    return is_thin ? at_reduced(reduced(x.lo())) : over_range(reduced(x.lo()), reduced(x.hi()));
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
        if (sin(Interval(y)).hi() <= v) {
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
