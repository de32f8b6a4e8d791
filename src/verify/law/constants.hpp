// The numbers of the law: C, k0, c0 (law.md).
#pragma once
#include "verify/law/slope.hpp"

namespace dumbbell_verify {

/// k0 = 3^(-7/4) pi^(-1/2), of the comparison function.
template <class N>
Interval<N> comparison_constant() {
    using I = Interval<N>;
    return I(1) / (I(3) * square_root(I(3) * square_root(I(3))) * square_root(pi<N>()));
}

/// c0 = 12 |zeta(-1/2)| k0. By the functional equation |zeta(-1/2)| = zeta(3/2)/(4 pi), and zeta(3/2) is the
/// sum of n^(-3/2): over n >= m, as n^(-3/2) falls and is convex, it lies above the integral from m on by
/// [1/2 f(m), 1/2 f(m) - f'(m)/12] (trapezoids, and Euler-Maclaurin).
template <class N>
Interval<N> law_constant() {
    using I = Interval<N>;
    constexpr int m = 1000;
    const auto term = [](int n) { return I(1) / (I(n) * square_root(I(n))); };
    I sum = 0;
    for (int n = 1; n < m; ++n) sum = sum + term(n);
    const I from = I(2) / square_root(I(m)) + term(m) / I(2), more = term(m) / I(8 * m);
    const I zeta = sum + I(from.lo, (from + more).hi);
    return I(3) * zeta / pi<N>() * comparison_constant<N>();
}

/// C, the integral of W(a) = sin((pi/2)/cos a) over [0, pi/3]: on each of equal parts, W at the middle and
/// W'' on the part. With x = (pi/2)/cos a, y = x - pi/2 and t = tan a: W = cos y, W'' = -cos y (x t)^2 - sin
/// y x (2 t^2 + 1).
template <class N>
Interval<N> growth_constant() {
    using I = Interval<N>;
    constexpr int parts = 1000;
    const I quarter = pi<N>() / I(2), h = pi<N>() / I(3 * parts), h3 = cube(h) / I(24);
    I sum = 0;
    for (int i = 0; i < parts; ++i) {
        const I middle = pi<N>() * fraction<N>(2 * i + 1, 6 * parts);
        const I a(middle.lo, middle.hi),
            part((pi<N>() * fraction<N>(i, 3 * parts)).lo, (pi<N>() * fraction<N>(i + 1, 3 * parts)).hi);
        sum = sum + sin_cos_on(quarter / sin_cos_on(a, quarter).cos - quarter, quarter).cos * h;
        const auto [s, c] = sin_cos_on(part, quarter);
        const I x = quarter / c, t2 = square(s / c);
        const auto [sin_y, cos_y] = sin_cos_on(x - quarter, quarter);
        sum = sum - (cos_y * square(x) * t2 + sin_y * x * (I(2) * t2 + I(1))) * h3;
    }
    return sum;
}

}  // namespace dumbbell_verify
