// Boxes, and points in them, for the tests of the adiabatic formulas.
#pragma once

#include <cmath>

#include "adiabatic/contact.hpp"
#include "rooms/number/random.hpp"

namespace dumbbell_test {

struct Samples : Random {
    using Random::Random;

    /// An interval of at most this relative width around x.
    dumbbell::Interval around(double x, double width) {
        return {x * (1 - uniform(0, width)), x * (1 + uniform(0, width))};
    }
    double in(const dumbbell::Interval& x) { return uniform(x.lo(), x.hi()); }
};

/// Whether an enclosure contains a number that was computed in long double.
inline bool holds(const dumbbell::Interval& x, long double value) {
    const long double slack = 1e-15L * (1 + std::abs(value));
    return x.lo() <= value + slack && value - slack <= x.hi();
}

/// r and beta2 at one delta.
struct PointMasses {
    long double delta, r, beta2;
    explicit PointMasses(long double d) : delta(d), r(d * d / (1 - d * d)), beta2(1 - d * d) {}
};

inline constexpr long double half_turn = 3.14159265358979323846264338327950288L;

inline long double f_at(long double x, const PointMasses& m) {
    return half_turn / 2 + std::asin(m.beta2 * std::sin(x));
}

inline long double h_at(long double x, long double kappa, const PointMasses& m) {
    const long double w = std::cos(x);
    return f_at(x, m) * w * (w - kappa) / (w * w + m.r);
}

/// The root of sin X - l X = height + l pi/2 in [0, upper], by halving.
inline long double root_below(long double height, long double l, long double upper) {
    long double lo = 0, hi = upper;
    for (int i = 0; i < 90; ++i) {
        const long double middle = (lo + hi) / 2;
        (std::sin(middle) - l * middle < height + l * half_turn / 2 ? lo : hi) = middle;
    }
    return lo;
}

}  // namespace dumbbell_test
