// The numbers of the law (law.md): where the conditions of its covers hold, and C, k0, c0.
#pragma once
#include <array>

#include "verify/wings/law/slope.hpp"

namespace dumbbell_verify::law {

/// numerator/denominator, in lowest terms.
struct Ratio {
    int numerator, denominator;
    operator mpq_class() const {  // NOLINT(google-explicit-constructor): the same number
        return {numerator, static_cast<unsigned>(denominator)};
    }
};
template <class N>
Interval<N> fraction(const Ratio& x) {
    return fraction<N>(x.numerator, x.denominator);
}

constexpr Ratio most_eps{1, 1000};
/// The layer is U <= 9/10 and rho <= 1/5, the bulk U >= 9/10, in three ranges of th, the end d <= 9/100.
constexpr Ratio layer_U{9, 10}, layer_rho{1, 5}, end_d{9, 100};
constexpr std::array<Ratio, 4> bulk_angles{{{0, 1}, {3, 5}, {7, 10}, {993, 1250}}};
/// J is in pi/2 + [-drift eps^2/u^3, rise eps^2], in the bulk Q in pi/2 + [least, most].
constexpr Ratio J_drift{53, 10}, J_rise{1, 4}, bulk_least_Q{-1, 100'000}, bulk_most_Q{3, 100'000};
/// To begin with Q is in pi/2 + [least, most] in the layer, in pi/2 + d [least, most] at the end (L53).
constexpr Ratio layer_least_Q{-1, 100}, layer_most_Q{1, 20}, end_least_Q{-1, 10}, end_most_Q{3, 5};
/// (C4).
constexpr Ratio least_delta{-23, 200}, most_delta{1, 50};
/// (C6) and (C7), the factors of y and Delta^2; (C8).
constexpr std::array<Ratio, 2> layer_least{{{-31, 200}, {-43, 100}}}, layer_most{{{1, 8}, {9, 20}}};
constexpr Ratio most_drift{159, 10};
/// (C9), p by 1, th^2, th^4, th^8, and its slack by 1, th^8; (C10), in each range.
constexpr std::array<Ratio, 4> bulk_p{{{-1, 3}, {47, 50}, {-207, 200}, {2107, 1000}}};
constexpr std::array<Ratio, 2> bulk_slack{{{3, 500}, {3, 4}}};
constexpr std::array<Ratio, 3> most_fall{{{21, 10}, {31, 5}, {227, 10}}};
/// (C11), its slack by 1, d.
constexpr Ratio end_surplus{-1657, 10'000};
constexpr std::array<Ratio, 2> end_slack{{{3, 1000}, {1, 2}}};

/// k0 = 3^(-7/4) pi^(-1/2), of the comparison function.
template <class N>
Interval<N> comparison_constant() {
    using I = Interval<N>;
    return I(1) / (I(3) * square_root(I(3) * square_root(I(3))) * square_root(pi<N>()));
}

/// zeta(3/2) = eta(3/2)/(1 - 2^(-1/2)). eta(3/2) is the sum of (-1)^k a_k, a_k = (k + 1)^(-3/2), the integral
/// of 1/(1 + x) by a measure on [0, 1] of which a_k are the moments: |ln x|^(1/2) dx/Gamma(3/2). With T(x) =
/// T_n(1 - 2x), Chebyshev's, (T(-1) - T(x))/(1 + x) is a polynomial, its coefficients are (-1)^k c_k, and
/// what is left is at most eta(3/2)/T(-1) < 1/T(-1), as |T| <= 1 on [0, 1]; T(-1) = T_n(3). (Cohen, Rodriguez
/// Villegas, Zagier: Convergence acceleration of alternating series, algorithm 1.)
template <class N>
Interval<N> zeta_of_three_halves() {
    using I = Interval<N>;
    const auto number = [](const mpz_class& x) { return I(bound(down, x, N(0)), bound(up, x, N(0))); };
    const long n = bits(N(0)) * 2 / 5 + 4;
    mpz_class before = 1, last = 3;  // T_{i-1}(3), T_i(3)
    for (long i = 1; i < n; ++i) {
        const mpz_class next = 6 * last - before;
        before = last;
        last = next;
    }
    mpz_class b = -1, c = -last;
    I sum = 0;
    for (long k = 0; k < n; ++k) {
        c = b - c;
        const I term(static_cast<int>(k + 1));
        sum = sum + number(c) / (term * square_root(term));
        b = b * (2 * (k + n) * (k - n)) / ((2 * k + 1) * (k + 1));  // without a remainder
    }
    const I all = number(last);
    return (sum + I(N(-1), N(1))) / all / (I(1) - I(1) / square_root(I(2)));
}

/// c0 = 12 |zeta(-1/2)| k0, and by the functional equation |zeta(-1/2)| = zeta(3/2)/(4 pi).
template <class N>
Interval<N> law_constant() {
    return Interval<N>(3) * zeta_of_three_halves<N>() / pi<N>() * comparison_constant<N>();
}

/// C, the integral of sin((pi/2) s) over [0, pi/3], s = 1/cos a. With sine's series it is the sum of (-1)^k
/// (pi/2)^n/n! S_n, n = 2k + 1, S_n the integral of s^n: S_1 = ln(2 + sqrt3) = (2/sqrt3) times the sum of
/// 3^-k/(2k + 1), (n + 1) S_{n+2} = 2^n sqrt3 + n S_n by parts, and S_{n+2} <= 4 S_n as s <= 2. So from n = 3
/// on the terms fall, and what is left of the alternating sum lies between 0 and the next one.
template <class N>
Interval<N> growth_constant() {
    using I = Interval<N>;
    const int digits = static_cast<int>(bits(N(0)));
    const I root = square_root(I(3)), quarter = pi<N>() / I(2);
    I S = 0, power = 1;
    for (int k = 0; k < digits; ++k) {
        S = S + power / I(2 * k + 1);
        power = power / I(3);
    }
    S = I(2) * (S + I(N(0), (power * I(2)).hi)) / root;
    I sum = 0, share = quarter, twice = root + root;  // (pi/2)^n/n!, 2^n sqrt3
    for (int n = 1; n < digits / 2 + 20; n += 2) {
        sum = n % 4 == 1 ? sum + share * S : sum - share * S;
        S = (twice + I(n) * S) / I(n + 1);
        share = share * square(quarter) / I((n + 1) * (n + 2));
        twice = I(4) * twice;
    }
    return sum + I((-(share * S)).lo, (share * S).hi);
}

}  // namespace dumbbell_verify::law
