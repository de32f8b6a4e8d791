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
constexpr double moved_error = 5.4;     // of `moved`, from there (L39 (h))
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
