// Intervals, and intervals with a slope: what is divided by U must be small with U, and be seen to be.
#pragma once
#include "verify/core/interval.hpp"
#include "verify/functions/angle.hpp"

namespace dumbbell_verify::law {

/// The values on the box of a factor that depends on U. One that does not depend on it is one as well.
template <class N>
struct Dependent {
    using I = Interval<N>;
    I values;

    Dependent(const I& x) : values(x) {}  // NOLINT(google-explicit-constructor): the weaker statement
    friend Dependent operator-(const Dependent& x) { return -x.values; }
    friend Dependent operator+(const Dependent& x, const Dependent& y) { return x.values + y.values; }
    friend Dependent operator-(const Dependent& x, const Dependent& y) { return x.values - y.values; }
    friend Dependent operator*(const Dependent& x, const Dependent& y) { return x.values * y.values; }
    friend Dependent operator/(const Dependent& x, const Dependent& y) { return x.values / y.values; }
};
template <class N>
const Interval<N>& values_of(const Interval<N>& x) {
    return x;
}
template <class N>
const Interval<N>& values_of(const Dependent<N>& x) {
    return x.values;
}

/// A quantity x that depends on one number U of a box [0, ...] or [U_lo, U_hi], and on others: for every U
/// there are x0 in `zero`, the quantity's value at U = 0 (with the others as they are), and x1 in `rise` with
/// x = x0 + U x1; and x lies in `whole`. The operations keep that.
template <class N>
struct Slope {
    using I = Interval<N>;
    I zero, rise, whole;

    friend Slope operator-(const Slope& x) { return {-x.zero, -x.rise, -x.whole}; }
    friend Slope operator+(const Slope& x, const Slope& y) {
        return {x.zero + y.zero, x.rise + y.rise, x.whole + y.whole};
    }
    friend Slope operator-(const Slope& x, const Slope& y) {
        return {x.zero - y.zero, x.rise - y.rise, x.whole - y.whole};
    }
    friend Slope operator*(const Slope& x, const Slope& y) {
        return {x.zero * y.zero, x.zero * y.rise + x.rise * y.whole, x.whole * y.whole};
    }
    /// Of x that is 0 at U = 0. Of any other the product's value there is unknown, and its slope.
    friend Slope operator*(const Slope& x, const Dependent<N>& k) {
        const bool vanishes = x.zero.lo == N(0) && x.zero.hi == N(0);
        const I unknown = I(1) / I(0), product = x.whole * k.values;
        return vanishes ? Slope{0, x.rise * k.values, product} : Slope{unknown, unknown, product};
    }
    friend Slope operator/(const Slope& x, const Slope& y) { return x * (I(1) / y); }
    // With numbers that do not depend on U.
    friend Slope operator/(const I& k, const Slope& y) {
        const I inverse = k / y.zero;
        return {inverse, -(y.rise * inverse / y.whole), k / y.whole};
    }
    friend Slope operator+(const Slope& x, const I& k) { return {x.zero + k, x.rise, x.whole + k}; }
    friend Slope operator+(const I& k, const Slope& x) { return x + k; }
    friend Slope operator-(const I& k, const Slope& x) { return -x + k; }
    friend Slope operator-(const Slope& x, const I& k) { return x + -k; }
    friend Slope operator*(const Slope& x, const I& k) { return {x.zero * k, x.rise * k, x.whole * k}; }
    friend Slope operator*(const I& k, const Slope& x) { return x * k; }
    friend Slope operator/(const Slope& x, const I& k) { return {x.zero / k, x.rise / k, x.whole / k}; }
};

/// The square roots of an interval without negative numbers; unbounded otherwise.
template <class N>
Interval<N> square_root(const Interval<N>& x) {
    return x.lo >= N(0) ? root(x) : Interval<N>(1) / Interval<N>(0);
}
template <class N>
Slope<N> square_root(const Slope<N>& x) {
    const Interval<N> zero = square_root(x.zero), whole = square_root(x.whole);
    return {zero, x.rise / (zero + whole), whole};
}
template <class N>
Slope<N> square(const Slope<N>& x) {
    return {square(x.zero), x.rise * (x.zero + x.whole), square(x.whole)};
}
template <class N>
Dependent<N> square(const Dependent<N>& x) {
    return square(x.values);
}
template <class N>
Dependent<N> square_root(const Dependent<N>& x) {
    return square_root(x.values);
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
template <class N>
Dependent<N> below_one(const Dependent<N>& y, const Interval<N>& k) {
    return below_one(y.values, k);
}
/// The numbers that lie in both; lo > hi if there is none.
template <class N>
Interval<N> common(const Interval<N>& x, const Interval<N>& y) {
    return {std::max(x.lo, y.lo), std::min(x.hi, y.hi)};
}
/// Numbers of any sign that are at most |x| for some x of X, and all x.
template <class N>
Interval<N> up_to_size(const Interval<N>& x) {
    const N size = std::max(-x.lo, x.hi);
    return {-size, size};
}
template <class N>
Dependent<N> up_to_size(const Dependent<N>& x) {
    return up_to_size(x.values);
}
/// sin x / x for x in [0, 2], where it falls; 1 at 0.
template <class N>
Interval<N> sinc(const Interval<N>& x) {
    if (!(x.lo >= N(0) && x.hi <= N(2))) return Interval<N>(1) / Interval<N>(0);
    return {series(square(Interval<N>(x.hi)), 2).lo, series(square(Interval<N>(x.lo)), 2).hi};
}
template <class N>
Dependent<N> sinc(const Dependent<N>& x) {
    return sinc(x.values);
}
/// cos x for x in [0, 2], where it falls.
template <class N>
Interval<N> falling_cosine(const Interval<N>& x) {
    if (!(x.lo >= N(0) && x.hi <= N(2))) return Interval<N>(1) / Interval<N>(0);
    return {series(square(Interval<N>(x.hi)), 1).lo, series(square(Interval<N>(x.lo)), 1).hi};
}

/// How the formulas of a rule are evaluated on a box of U: in intervals (`Form` Interval) or with slopes.
template <class N, template <class> class Form>
struct Along {
    using I = Interval<N>;
    using T = Form<N>;
    static constexpr bool has_slopes = !std::is_same_v<T, I>;
    using Factor = std::conditional_t<has_slopes, Dependent<N>, I>;  ///< may depend on U
    const Factor U;

    /// x0 + U x1 that lies in `whole` as well.
    [[nodiscard]] T make(const I& zero, const Factor& rise, const Factor& whole) const {
        if constexpr (has_slopes)
            return {zero, rise.values, whole.values};
        else
            return whole;
    }
    [[nodiscard]] T line(const I& zero, const Factor& rise) const {
        return make(zero, rise, zero + U * rise);
    }
    /// The values of the quantity.
    [[nodiscard]] Factor values(const T& x) const {
        if constexpr (has_slopes)
            return common(x.whole, x.zero + U.values * x.rise);
        else
            return x;
    }
    /// The same, without its slope.
    [[nodiscard]] Factor whole(const T& x) const {
        if constexpr (has_slopes)
            return x.whole;
        else
            return x;
    }
    /// sinc(k U) and cos(k U) for numbers k >= 0, k U in [0, 2]: with x = k U, 1 - sinc x lies in
    /// (x^2/6) [1 - x^2/20, 1] and 1 - cos x in (x^2/2) [1 - x^2/12, 1] (alternating series).
    [[nodiscard]] T sinc_of(const I& k) const {
        const Factor x = k * U, share = below_one(square(x), fraction<N>(1, 20));
        return make(1, -(k * x / I(6) * share), sinc(x));
    }
    [[nodiscard]] T cos_of(const I& k) const {
        const Factor x = k * U, share = below_one(square(x), fraction<N>(1, 12));
        return make(1, -(k * x / I(2) * share), falling_cosine(values_of(x)));
    }
    /// w (1 - s x^2 [1 - t x^2, 1]) with x = k U.
    [[nodiscard]] T nearly(const I& w, const I& k, const I& s, const I& t) const {
        const Factor x = k * U, share = s * below_one(square(x), t);
        return make(w, -(w * k * x * share), w * (I(1) - square(x) * share));
    }
};

}  // namespace dumbbell_verify::law
