#include "flight/contact_guess.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "flight/way_to_contact.hpp"
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

/// A point near the root, mostly: from the first terms of its series.
double first_point(double c, double kappa) {
    const double inverse = 1 / (1 - kappa);
    const double t = c * inverse;
    const double s = std::min(t * t * inverse * (1.0 / 6), 0.15);
    return t * (1 + s + s * s * (3 + s * 12));
}

/// The last of a few steps of fourth order: from z, where sine and cosine are `at`, to the root, about.
struct LastStep {
    double z;
    SinCosGuess at;
    double root;
};

/// From a point near the root; nothing unless such steps lead there.
std::optional<LastStep> last_step(double z, double c, double kappa) {
    for (int step = 0; step < 6; ++step) {
        if (!(z >= 0 && z <= half_pi_guess)) {
            return std::nullopt;
        }
        const SinCosGuess at = guess_sin_cos(z);
        const double slope = at.cos - kappa;
        if (!(slope > 0)) {
            return std::nullopt;
        }
        const double inverse = 1 / slope;
        const double newton = (c + kappa * z - at.sin) * inverse;
        // How far from a straight line the sine is on this way, by its second and third derivatives.
        const double bend = std::abs(0.5 * at.sin * inverse * newton);
        const double twist = at.cos * inverse * (1.0 / 6) * newton * newton;
        const double root = z + (bend + twist < 0.25 ? way_to_contact(newton, inverse, at) : newton);
        if (4 * std::abs(newton) * (bend * bend * bend + twist * (bend + twist)) <= 0x1p-52 * root) {
            return root <= half_pi_guess ? std::optional(LastStep{z, at, root}) : std::nullopt;
        }
        z = root;
    }
    return std::nullopt;
}

std::pair<LastStep, bool> guess(double c, double kappa, double start) {
    if (kappa < 1) {
        if (const auto step = last_step(start >= 0 ? start : first_point(c, kappa), c, kappa)) {
            return {*step, true};
        }
    }
    const double top = miss(kappa).z;
    const SinCosGuess at = guess_sin_cos(top);
    if (at.sin - kappa * top < c) {
        return {{top, at, top}, false};
    }
    const auto [z, hits] = newton(c, kappa);
    return {{z, guess_sin_cos(z), z}, hits};
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

ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa, double start) noexcept {
    const auto [step, hits] = guess(approximate(c), approximate(kappa), start);
    return {Interval(step.root), hits};
}

[[gnu::flatten]] ContactPlace<Interval> contact_place(const Interval& c, const Interval& kappa,
                                                      double start) noexcept {
    const auto [step, hits] = guess(approximate(c), approximate(kappa), start);
    const auto& [z, at, root] = step;
    const Interval x(root);
    const bool near = z >= 0x1p-900 && std::abs(root - z) <= 0x1p-8 * std::min({at.sin, at.cos, 0x1p-5});
    return {x, near ? sin_cos_beside(at, root - z) : sin_cos(x), hits};
}

ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa, double start) {
    const double slope = approximate(kappa);
    const auto [step, hits] = guess(approximate(c), slope, start);
    const double z = step.root;
    constexpr double far_from_tangency = 0x1p-10;
    const double steepness = guess_sin_cos(z).cos - slope;
    if (hits && steepness > far_from_tangency) {
        return {refined_root(BigInterval(z), c, kappa, 50 + std::ilogb(steepness)), true};
    }
    // Near a tangency double precision may err about whether there is a root: look at the top of g, where it
    // is well conditioned.
    const BigInterval flat = BigInterval(1) - kappa;  // where doubles no longer tell kappa from 1
    const BigInterval top = refined_top(
        certainly_positive(flat) && flat.hi() < 0x1p-40 ? sqrt(flat + flat) : BigInterval(miss(slope).z),
        kappa);
    const auto at = sin_cos(top);
    const BigInterval height = midpoint(at.sin - kappa * top - c);
    if (!certainly_positive(height)) {
        return {top, false};
    }
    const BigInterval left = clamped(top - sqrt(BigInterval(2) * height / at.sin));
    return {refined_root(left, c, kappa, 20), true};
}

}  // namespace dumbbell::flight
