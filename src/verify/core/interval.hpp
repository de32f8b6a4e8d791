// Intervals on a number type N with the vocabulary of number.hpp, and sin and cos in them.
#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "verify/core/number.hpp"

namespace dumbbell_verify {

/// The set {x : lo <= x <= hi}. For all a in A, b in B: a op b lies in A op B. No bound is ever NaN.
template <class N>
struct Interval {
    N lo, hi;

    Interval(const N& x) : lo(x), hi(x) {}           // NOLINT(google-explicit-constructor): x encloses itself
    constexpr Interval(int n = 0) : lo(n), hi(n) {}  // NOLINT(google-explicit-constructor): exact
    constexpr Interval(N low, N high) : lo(std::move(low)), hi(std::move(high)) {}

    friend Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
    friend Interval operator+(const Interval& a, const Interval& b) {
        return {add(down, a.lo, b.lo), add(up, a.hi, b.hi)};
    }
    friend Interval operator-(const Interval& a, const Interval& b) {
        return {sub(down, a.lo, b.hi), sub(up, a.hi, b.lo)};
    }
    friend Interval operator*(const Interval& a, const Interval& b) {
        if (b.lo >= 0)
            return {mul(down, a.lo, a.lo < 0 ? b.hi : b.lo), mul(up, a.hi, a.hi < 0 ? b.lo : b.hi)};
        if (a.lo >= 0) return b * a;
        const auto corners = [&](Round d) {
            return std::minmax(
                {mul(d, a.lo, b.lo), mul(d, a.lo, b.hi), mul(d, a.hi, b.lo), mul(d, a.hi, b.hi)});
        };
        return {corners(down).first, corners(up).second};
    }
    /// Unbounded unless the divisor is positive.
    friend Interval operator/(const Interval& a, const Interval& b) {
        if (!(b.lo > 0)) return {div(down, N(-1), N(0)), div(up, N(1), N(0))};
        return {div(down, a.lo, a.lo < 0 ? b.lo : b.hi), div(up, a.hi, a.hi < 0 ? b.hi : b.lo)};
    }
};
struct Excluded {};  ///< thrown where two enclosures of the same thing exclude each other

template <class N>
Interval<N> pi() {
    return {pi_bound(down, N(0)), pi_bound(up, N(0))};
}

/// y / (k (k + 1)); for double by a table, because a division is slow.
template <class N>
Interval<N> scaled(const Interval<N>& y, int k) {
    return {div(down, y.lo, k * (k + 1)), div(up, y.hi, k * (k + 1))};
}
/// Made of integers by the compiler: no thread's rounding has a say in it.
inline constexpr auto reciprocals = [] {
    std::array<Interval<double>, 28> table{};
    for (std::uint64_t k = 1; k < 28; ++k) {
        const std::uint64_t n = k * (k + 1);
        std::uint64_t power = std::uint64_t{1} << 53;
        while (power / n < std::uint64_t{1} << 52) power *= 2;
        const std::uint64_t least = power / n, most = least + (power % n != 0);  // of 53 bits
        const auto one = static_cast<double>(power);
        table[k] = {static_cast<double>(least) / one, static_cast<double>(most) / one};
    }
    return table;
}();
inline double scaled(const double& y, int k) { return y * reciprocals[k].lo; }
inline Interval<double> scaled(const Interval<double>& y, int k) { return y * reciprocals[k]; }

/// 1 - y/(k(k+1)) (1 - y/((k+2)(k+3)) (1 - ... tail)), n nested brackets, k = first.
template <class T>
T brackets(const T& y, int first, int n, T tail) {
    for (int k = first + 2 * (n - 1); k >= first; k -= 2) tail = T(1) - scaled(y, k) * tail;
    return tail;
}

/// The infinite nest for y in [0, 4], first = 1 (cos x, y = x^2) or 2 (sin x / x). Behind n brackets is left
/// a series 1 - a1 + a1 a2 - ..., 0 <= a = y/(k(k+1)) <= 1/3, alternating and decreasing: the tail is in [0,
/// 1]. In double the brackets from k = 7 on are no enclosures: a <= 1/14 there, with a relative error <=
/// 2^-50, so each turns the error E of its tail into at most E/14 + 1.4 * 2^-53, and ten turn the first E <=
/// 1 into less than 2^-51.
template <class N>
Interval<N> series(const Interval<N>& y, int first) {
    if constexpr (std::is_same_v<N, double>) {
        const double inner = brackets(y.lo, first + 6, 10, 1.0);
        return brackets(y, first, 3, Interval<N>(inner - 0x1p-50, inner + 0x1p-50));
    } else {
        return brackets(y, first, terms(y.hi), Interval<N>(N(0), N(1)));
    }
}

template <class T>
struct SinCos {
    T sin, cos;
};

/// Enclosures of sin z and cos z for a number z in [0, 2]; [-1, 1] for any other.
template <class N>
SinCos<Interval<N>> sin_cos(const N& z) {
    const Interval<N> whole(N(-1), N(1));
    if (!(z >= N(0) && z <= N(2))) return {whole, whole};
    const Interval<N> x = z, y = x * x;
    return {x * series(y, 2), series(y, 1)};
}

}  // namespace dumbbell_verify
