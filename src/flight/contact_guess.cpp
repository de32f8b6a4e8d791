#include "flight/contact_guess.hpp"

#include <algorithm>
#include <cmath>

#include "number/elementary.hpp"

namespace dumbbell::flight {
namespace {

constexpr double half_pi_guess = 0x1.921fb54442d18p+0;

struct Point {
    double z;
    bool hits;
};

Point miss(double kappa) { return {kappa <= 0 ? half_pi_guess : std::acos(std::min(1.0, kappa)), false}; }

/// Newton's iteration on the concave g(x) = sin x - kappa x - c from a point left of its least root: it
/// increases and stays left, or runs over the top of g when there is no root. Near a double root it only
/// halves the distance: hence the many steps allowed.
Point newton(double c, double kappa, double from) {
    double x = kappa < 1 ? std::max(c / (1 - kappa), from) : half_pi_guess;
    for (int step = 0; step < 60; ++step) {
        if (!(x <= half_pi_guess)) {
            return miss(kappa);
        }
        const SinCosGuess at = guess_sin_cos(x);
        const double slope = at.cos - kappa;
        if (!(slope > 0)) {
            return miss(kappa);
        }
        const double next = x - (at.sin - kappa * x - c) / slope;
        if (!(std::abs(next - x) > 0x1p-50 * x)) {
            return {std::clamp(next, 0.0, half_pi_guess), true};
        }
        x = std::max(next, 0.0);
    }
    return {x, true};
}

/// The middle of the part in [0, pi/2].
BigInterval clamped(const BigInterval& z) {
    if (certainly_positive(z) && certainly_at_most(z, half_pi<BigInterval>())) {
        return midpoint(z);
    }
    return midpoint(max(BigInterval(0), min(z, low_end(half_pi<BigInterval>()))));
}

/// The root of g(x) = sin x - kappa x - c near z, of which `known` bits are right, to the working precision.
BigInterval refined_root(BigInterval z, const BigInterval& c, const BigInterval& kappa, int known) {
    const int needed = PrecisionScope::current();
    while (true) {
        const auto at = sin_cos(z);
        const BigInterval slope = at.cos - kappa;
        const BigInterval step = (at.sin - kappa * z - c) / slope;
        if (2 * known >= needed) {  // Newton's step doubles them
            return clamped(z - step);
        }
        // With the next term of Taylor's formula they become three times as many.
        z = clamped(z - (step - at.sin * sqr(step) / (slope + slope)));
        known *= 3;
        if (known >= needed) {
            return z;
        }
    }
}

BigInterval refined_top(BigInterval z, const BigInterval& kappa) {
    int known = 20;
    do {
        const auto at = sin_cos(z);
        z = clamped(z + (at.cos - kappa) / at.sin);
        known *= 2;
    } while (known < PrecisionScope::current());
    return z;
}

}  // namespace

ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa, double from) noexcept {
    const Point guess = newton(approximate(c), approximate(kappa), from);
    return {Interval(guess.z), guess.hits};
}

ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa, double from) {
    const double slope = approximate(kappa);
    const Point guess = newton(approximate(c), slope, from);
    constexpr double far_from_tangency = 0x1p-10;
    const double steepness = guess_sin_cos(guess.z).cos - slope;
    if (guess.hits && steepness > far_from_tangency) {
        return {refined_root(BigInterval(guess.z), c, kappa, 50 + std::ilogb(steepness)), true};
    }
    // Near a tangency double precision may err about whether there is a root: look at the top of g, where it
    // is well conditioned.
    const BigInterval top = refined_top(BigInterval(miss(slope).z), kappa);
    const auto at = sin_cos(top);
    const BigInterval height = midpoint(at.sin - kappa * top - c);
    if (!certainly_positive(height)) {
        return {top, false};
    }
    const BigInterval left = clamped(top - sqrt(BigInterval(2) * height / at.sin));
    return {refined_root(left, c, kappa, 20), true};
}

}  // namespace dumbbell::flight
