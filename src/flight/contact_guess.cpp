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

/// Newton's iteration z + step(z) from double precision to the working precision. It converges
/// quadratically: the early steps need no more bits than they can win, and a step that is short in
/// comparison with its precision is the last.
template <class Step>
BigInterval refined(BigInterval z, const Step& step) {
    const int all = PrecisionScope::current();
    for (int won = 80;; won *= 2) {
        const PrecisionScope scope(std::min(won + 48, all));
        const BigInterval next = clamped(z + step(z));
        const BigInterval change = next - z;
        z = next;
        const bool is_short =
            certainly_at_most(max(change, -change), power_of_two(-PrecisionScope::current() / 2 - 8));
        if (PrecisionScope::current() == all && (is_short || won >= 2 * all)) {
            return z;
        }
    }
}

BigInterval refined_root(const BigInterval& z, const BigInterval& c, const BigInterval& kappa) {
    return refined(z, [&](const BigInterval& x) {
        const auto at = sin_cos(x);
        return -((at.sin - kappa * x - c) / (at.cos - kappa));
    });
}

BigInterval refined_top(const BigInterval& z, const BigInterval& kappa) {
    return refined(z, [&](const BigInterval& x) {
        const auto at = sin_cos(x);
        return (at.cos - kappa) / at.sin;
    });
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
        return {refined_root(BigInterval(guess.z), c, kappa), true};
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
    return {refined_root(left, c, kappa), true};
}

}  // namespace dumbbell::flight
