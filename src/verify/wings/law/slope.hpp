// Intervals that know what a quantity does near U = 0: what is divided by U, or by U^2, must be small with U,
// and be seen to be.
#pragma once
#include "verify/core/interval.hpp"
#include "verify/functions/angle.hpp"

namespace dumbbell_verify::law {

/// A quantity x that depends on one number U of a box [U_lo, U_hi], U_lo >= 0, and on others: with the others
/// as they are there are x0 in `zero`, x1 in `first`, y1 in `rise` and x2 in `bend` with x = x0 + U y1 = x0 +
/// U x1 + U^2 x2, where x0 and x1 do not depend on U; and x lies in `whole`. The operations keep that.
template <class N>
struct Slope {
    using I = Interval<N>;
    I zero, first, rise, bend, whole;

    friend Slope operator-(const Slope& x) { return {-x.zero, -x.first, -x.rise, -x.bend, -x.whole}; }
    friend Slope operator+(const Slope& x, const Slope& y) {
        return {x.zero + y.zero, x.first + y.first, x.rise + y.rise, x.bend + y.bend, x.whole + y.whole};
    }
    friend Slope operator-(const Slope& x, const Slope& y) { return x + -y; }
    friend Slope operator*(const Slope& x, const Slope& y) {
        return {x.zero * y.zero, x.zero * y.first + x.first * y.zero, x.zero * y.rise + x.rise * y.whole,
                x.zero * y.bend + x.first * y.rise + x.bend * y.whole, x.whole * y.whole};
    }
    friend Slope operator/(const Slope& x, const Slope& y) { return x * (I(1) / y); }
    // With numbers that do not depend on U. Nothing is known of k/y unless y is greater than 0.
    friend Slope operator/(const I& k, const Slope& y) {
        const I zero = I(1) / y.zero, whole = I(1) / y.whole, both = zero * whole;
        return Slope{zero, -(y.first * square(zero)), -(y.rise * both),
                     (y.first * y.rise * zero - y.bend) * both, whole} *
               k;
    }
    friend Slope operator+(const Slope& x, const I& k) {
        return {x.zero + k, x.first, x.rise, x.bend, x.whole + k};
    }
    friend Slope operator+(const I& k, const Slope& x) { return x + k; }
    friend Slope operator-(const I& k, const Slope& x) { return -x + k; }
    friend Slope operator-(const Slope& x, const I& k) { return x + -k; }
    friend Slope operator*(const Slope& x, const I& k) {
        return {x.zero * k, x.first * k, x.rise * k, x.bend * k, x.whole * k};
    }
    friend Slope operator*(const I& k, const Slope& x) { return x * k; }
    friend Slope operator/(const Slope& x, const I& k) { return x * (I(1) / k); }
};

/// The square roots of an interval without negative numbers; unbounded otherwise.
template <class N>
Interval<N> square_root(const Interval<N>& x) {
    return x.lo >= N(0) ? root(x) : Interval<N>(1) / Interval<N>(0);
}
template <class N>
Slope<N> square_root(const Slope<N>& x) {
    const Interval<N> zero = square_root(x.zero), whole = square_root(x.whole), sum = zero + whole;
    const Interval<N> first = x.first / (zero + zero), rise = x.rise / sum;
    return {zero, first, rise, (x.bend - first * rise) / sum, whole};
}
template <class N>
Slope<N> square(const Slope<N>& x) {
    const Interval<N> sum = x.zero + x.whole;
    return {square(x.zero), x.zero * x.first * Interval<N>(2), x.rise * sum, x.first * x.rise + x.bend * sum,
            square(x.whole)};
}
template <class T>
T cube(const T& x) {
    return x * square(x);
}

/// p/q, for small integers.
template <class N>
Interval<N> fraction(int p, int q) {
    return Interval<N>(p) / Interval<N>(q);
}
/// [1 - k y, 1], for k >= 0, y >= 0.
template <class N>
Interval<N> below_one(const Interval<N>& y, const Interval<N>& k) {
    return {(Interval<N>(1) - k * y).lo, N(1)};
}
/// Numbers of any sign that are at most |x| for some x of X, and all x.
template <class N>
Interval<N> up_to_size(const Interval<N>& x) {
    const N size = std::max(-x.lo, x.hi);
    return {-size, size};
}
/// A function of x in [0, 2] that falls, from its value at a number's square; unbounded for any other x.
template <class N, class Function>
Interval<N> falling(const Interval<N>& x, const Function& of_square) {
    if (!(x.lo >= N(0) && x.hi <= N(2))) return Interval<N>(1) / Interval<N>(0);
    return {of_square(square(Interval<N>(x.hi))).lo, of_square(square(Interval<N>(x.lo))).hi};
}
/// sin x / x, 1 at 0, and cos x.
template <class N>
Interval<N> sinc(const Interval<N>& x) {
    return falling(x, [](const Interval<N>& y) { return series(y, 2); });
}
template <class N>
Interval<N> falling_cosine(const Interval<N>& x) {
    return falling(x, [](const Interval<N>& y) { return series(y, 1); });
}
/// 1 - y/(k (k + 1)) (1 - y/((k + 2)(k + 3)) ...), y = x^2: (1 - cos x)/(x^2/2) for k = 3, (1 - sinc
/// x)/(x^2/6) for k = 4. What is left after some brackets is in [0, 1], as y <= 4.
template <class N>
Interval<N> falling_share(const Interval<N>& x, int k) {
    const int n = std::is_same_v<N, double> ? 10 : static_cast<int>(bits(N(0)) / 8) + 10;
    return falling(x, [&](const Interval<N>& y) { return brackets(y, k, n, Interval<N>(N(0), N(1))); });
}

/// Slopes on a box of U.
template <class N>
struct Along {
    using I = Interval<N>;
    using S = Slope<N>;
    const I U;

    /// x0 + U x1, for numbers that do not depend on U.
    [[nodiscard]] S line(const I& zero, const I& first) const {
        return {zero, first, first, I(0), zero + U * first};
    }
    /// x0 + U^2 x2, where x2 may depend on U.
    [[nodiscard]] S curve(const I& zero, const I& bend) const {
        return {zero, I(0), U * bend, bend, zero + square(U) * bend};
    }
    /// U^2 x2 times what may depend on U; nothing is known unless x is of that form.
    [[nodiscard]] S times(const S& x, const I& k) const {
        for (const I& part : {x.zero, x.first})
            if (!(part.lo == N(0) && part.hi == N(0))) return x * (I(1) / I(0));
        return x * k;
    }
    /// The values of the quantity.
    [[nodiscard]] I values(const S& x) const {
        return meet(meet(x.whole, x.zero + U * x.rise), x.zero + U * (x.first + U * x.bend));
    }
    /// The same quantity, with all that is known of it in each part.
    [[nodiscard]] S tight(const S& x) const {
        return {x.zero, x.first, meet(x.rise, x.first + U * x.bend), x.bend, values(x)};
    }
    /// sinc(k U) and cos(k U) for numbers k >= 0, k U in [0, 2]: 1 - x^2/6 (1 - x^2/20 ...) and 1 - x^2/2 (1
    /// - x^2/12 ...), x = k U.
    [[nodiscard]] S sinc_of(const I& k) const {
        S result = curve(1, -(square(k) / I(6) * falling_share(k * U, 4)));
        result.whole = sinc(k * U);
        return result;
    }
    [[nodiscard]] S cos_of(const I& k) const {
        S result = curve(1, -(square(k) / I(2) * falling_share(k * U, 3)));
        result.whole = falling_cosine(k * U);
        return result;
    }
};

}  // namespace dumbbell_verify::law
