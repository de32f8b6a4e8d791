// Arithmetic for guesses: it promises nothing.
#pragma once
#include "verify/guess/square_root.hpp"

namespace dumbbell_verify {

inline Big operator+(const Big& a, const Big& b) { return add(down, a, b); }
inline Big operator-(const Big& a, const Big& b) { return sub(down, a, b); }
inline Big operator*(const Big& a, const Big& b) { return mul(down, a, b); }
inline Big operator/(const Big& a, const Big& b) { return div(down, a, b); }

inline Big scaled(const Big& y, int k) { return div(down, y, k * (k + 1)); }

/// The last relative step of an iteration of third order: what is left is about its cube.
inline double guess_tolerance(double) { return 0x1p-20; }
inline Big guess_tolerance(const Big&) {
    return Big::rounded(down, mpfr_set_ui_2exp, 1UL, -Big::precision / 3 - 8);
}
/// The same of second order.
inline double newton_tolerance(double) { return 0x1p-26; }
inline Big newton_tolerance(const Big&) {
    return Big::rounded(down, mpfr_set_ui_2exp, 1UL, -Big::precision / 2 - 8);
}

/// Next to a double root each step but the last ones gains one bit.
inline long most_steps(double) { return 40; }
inline long most_steps(const Big&) { return std::max<long>(40, Big::precision); }

/// For z in [0, 2].
template <class N>
SinCos<N> guess_sin_cos(const N& z) {
    const N y = z * z;
    const int n = [&] {
        if constexpr (std::is_same_v<N, double>)
            return 12;
        else
            return terms(y);
    }();
    return {z * brackets(y, 2, n, N(1)), brackets(y, 1, n, N(1))};
}

/// Near the z in [0, pi] with cos z = slope, and in [0, pi]; at its ends if the slope is beyond [-1, 1].
template <class N>
N guess_slope(const N& slope, const N& half_turn, const N& quarter) {
    if (!(slope < N(1))) return N(0);
    if (!(slope > -N(1))) return half_turn;
    const N z = slope < N(0) ? half_turn - guess_top<N>(-slope, quarter) : guess_top(slope, quarter);
    return z > N(0) ? std::min(z, half_turn) : N(0);
}

}  // namespace dumbbell_verify
