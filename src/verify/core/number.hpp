// Directed rounding for double, in round-to-nearest and without touching the rounding mode: each result is
// corrected by the sign of its exact error (TwoSum, or the residual of a fused multiply-add).
//
// Guarantee of add, mul, div, bound, pi_bound: rounded down, the result is at most the exact value, rounded
// up at least; it is never NaN. Where the error would not be exact they return a weaker bound, at worst -inf
// or +inf, unbounded: then nothing is known, nor of what is made of it, and what needs it fails.
#pragma once
#include <gmpxx.h>
#include <mpfr.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

// What the compiler tells of its flags; arithmetic_works() finds what it does not tell.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "dumbbell-verify must not be compiled with -ffast-math or its parts: its bounds rely on IEEE 754"
#endif
static_assert(FLT_EVAL_METHOD == 0 && std::numeric_limits<double>::is_iec559, "needs IEEE 754 doubles");

namespace dumbbell_verify {
enum Round { down, up };

inline double unbounded(Round d) { return d == up ? HUGE_VAL : -HUGE_VAL; }

/// s, or its neighbour in direction d if the exact value s + error lies there. |error| <= one unit of s; only
/// its sign is used (0 if s = 0), and without a branch, because it is a coin toss.
inline double settle(Round d, double s, double error) {
    const auto bits = std::bit_cast<std::int64_t>(s), away = (bits >> 63) | 1;
    return std::bit_cast<double>(bits + (d == up ? away * (error > 0) : -away * (error < 0)));
}

/// TwoSum: its error term is exact, also for subnormal results, if nothing overflows.
inline double add(Round d, double a, double b) {
    if (!(std::abs(a) <= 0x1p1000 && std::abs(b) <= 0x1p1000)) return unbounded(d);
    const double s = a + b, part = s - a;
    return settle(d, s, (a - (s - part)) + (b - part));
}
inline double sub(Round d, double a, double b) { return add(d, a, -b); }

/// The residual a b - p is 0 or at least 2^-106 |p| in size, so the fma is exact for |p| >= 2^-900.
inline double mul(Round d, double a, double b) {
    const double p = a * b, size = std::abs(p);
    if (!(size <= 0x1p1000)) return unbounded(d);  // 0 times what is unbounded, too
    if (size < 0x1p-900) return a == 0 || b == 0 ? 0 : d == up ? 0x1p-899 : -0x1p-899;
    return settle(d, p, std::fma(a, b, -p));
}

/// The residual a - q b is 0 or at least 2^-106 |a| in size: exact likewise. The error is residual / b.
inline double div(Round d, double a, double b) {
    const double q = a / b, size = std::abs(q);
    if (!(size <= 0x1p900 && std::abs(b) <= 0x1p900)) return unbounded(d);
    if (size < 0x1p-900) return a == 0 ? 0 : d == up ? 0x1p-899 : -0x1p-899;
    if (std::abs(a) < 0x1p-900) return unbounded(d);
    const double residual = std::fma(-q, b, a);
    return settle(d, q, b > 0 ? residual : -residual);
}

/// An exact rational; of 0 it is 0. get_d() rounds towards zero; the comparison with its result is exact.
inline double bound(Round d, const mpq_class& x, double) {
    const double size = static_cast<double>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
                        static_cast<double>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
    if (std::abs(size) > 890) return size > 0 ? unbounded(d) : d == up ? 0x1p-880 : -0x1p-880;
    const double s = x.get_d();
    return settle(d, s, cmp(x, mpq_class(s)));
}

/// MPFR rounds pi correctly; at 53 bits the result is a double.
inline double pi_bound(Round d, double) {
    MPFR_DECL_INIT(x, 53);
    mpfr_const_pi(x, d == up ? MPFR_RNDU : MPFR_RNDD);
    return mpfr_get_d(x, MPFR_RNDN);
}

inline double to_double(Round, double x) { return x; }
inline long bits(double) { return 53; }

}  // namespace dumbbell_verify
