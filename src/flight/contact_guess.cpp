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
Point newton(double c, double kappa) {
    double x = kappa < 1 ? c / (1 - kappa) : half_pi_guess;
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

BigInterval clamped(const BigInterval& z) {
    return midpoint(max(BigInterval(0), min(z, low_end(half_pi<BigInterval>()))));
}

/// Quadratic convergence from double precision to the working precision.
int refinements() {
    int steps = 1;
    for (int bits = 40; bits < PrecisionScope::current(); bits *= 2) {
        ++steps;
    }
    return steps;
}

BigInterval refined_root(BigInterval z, const BigInterval& c, const BigInterval& kappa, int steps) {
    for (; steps > 0; --steps) {
        const auto at = sin_cos(z);
        z = clamped(z - (at.sin - kappa * z - c) / (at.cos - kappa));
    }
    return z;
}

BigInterval refined_top(BigInterval z, const BigInterval& kappa) {
    for (int i = refinements(); i > 0; --i) {
        const auto at = sin_cos(z);
        z = clamped(z + (at.cos - kappa) / at.sin);
    }
    return z;
}

}  // namespace

ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa) noexcept {
    const Point guess = newton(approximate(c), approximate(kappa));
    return {Interval(guess.z), guess.hits};
}

ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa) {
    const double slope = approximate(kappa);
    const Point guess = newton(approximate(c), slope);
    constexpr double far_from_tangency = 0x1p-10;
    if (guess.hits && guess_sin_cos(guess.z).cos - slope > far_from_tangency) {
        // Here the guess is better than 40 bits.
        return {refined_root(BigInterval(guess.z), c, kappa, std::max(1, refinements() - 1)), true};
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
    return {refined_root(left, c, kappa, refinements()), true};
}

}  // namespace dumbbell::flight
