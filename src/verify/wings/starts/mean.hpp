// Theorem 6: how often incoming trajectories hit the floor on average, in plain sums.
#pragma once
#include "verify/functions/angle.hpp"

namespace dumbbell_verify::starts {

/// Encloses E(-m), the integral of f = (1 + m sin^2 t)^(1/2) over [0, pi/2], for m >= 0. f rises; f'' has the
/// sign of 1 - 2 z - m z^2, z = sin^2 t, which falls. So on a part where f is convex or concave the integral
/// lies between those by f in the middle and by the mean of f at the ends, and on any between those by f at
/// the ends.
inline Interval<double> elliptic(const Interval<double>& m) {
    using I = Interval<double>;
    constexpr int parts = 1 << 13;
    const I quarter = pi<double>() / I(2);
    struct Place {
        I f, bend;
    };
    const auto place = [&](int halves) -> Place {
        const I z = square(sin_cos_on(quarter * I(halves) / I(2 * parts), quarter).sin);
        return {root(I(1) + m * z), I(1) - I(2) * z - m * square(z)};
    };
    I sum = 0;
    Place from = place(0);
    for (int i = 0; i < parts; ++i) {
        const Place to = place(2 * i + 2);
        const bool one_way = to.bend.lo >= 0 || from.bend.hi <= 0;
        sum = sum + (one_way ? hull(place(2 * i + 1).f, (from.f + to.f) / I(2)) : hull(from.f, to.f));
        from = to;
    }
    return sum * quarter / I(parts);
}

/// Of all incoming trajectories at the mass ratio q.
struct Means {
    Interval<double> all;    ///< the mean number of collisions
    Interval<double> heavy;  ///< the probability that the heavy mass hits the floor
};
inline Means means(const mpq_class& q) {
    using I = Interval<double>;
    const auto number = [](const mpq_class& x) { return I(bound(down, x, 0.0), bound(up, x, 0.0)); };
    const I heavy = elliptic(number(1 / q)) / pi<double>();
    return {elliptic(number(q)) / pi<double>() + heavy, heavy};
}

}  // namespace dumbbell_verify::starts
