// Directed rounding for double, in round-to-nearest and without touching the rounding mode: each result is
// moved to its neighbour, even an exact one.
//
// Guarantee of add, mul, div, bound, pi_bound: rounded down, the result is at most the exact value, rounded
// up at least; it is never NaN. Where numbers are too small or too large they return a weaker bound, at worst
// -inf or +inf, unbounded: then nothing is known, nor of what is made of it, and what needs it fails.
#pragma once
#include <gmpxx.h>
#include <mpfr.h>

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

/// L13: on the side d of every number of which s is the nearest double: s's neighbour there, a weaker bound
/// where that might be wrong; s itself if `zero`, which says that the number is 0.
inline double outward(Round d, double s, bool zero) {
    const double size = std::abs(s), step = size * 0x1.0000000000001p-53;
    if (size >= 0x1p-900 && size <= 0x1p1000) [[likely]]
        return d == up ? s + step : s - step;
    if (!(size < 1)) return unbounded(d);
    return zero ? 0 : d == up ? 0x1p-899 : -0x1p-899;
}

/// A sum that is rounded to 0 is 0.
inline double add(Round d, double a, double b) { return outward(d, a + b, a + b == 0); }
inline double sub(Round d, double a, double b) { return add(d, a, -b); }
inline double mul(Round d, double a, double b) { return outward(d, a * b, a == 0 || b == 0); }
inline double div(Round d, double a, double b) {
    return std::abs(b) <= 0x1p900 ? outward(d, a / b, a == 0) : unbounded(d);
}

/// An exact rational, closely. get_d() rounds towards zero; the comparison with its result is exact.
inline double bound(Round d, const mpq_class& x, double) {
    const double size = static_cast<double>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
                        static_cast<double>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
    if (std::abs(size) > 890) return size > 0 ? unbounded(d) : d == up ? 0x1p-880 : -0x1p-880;
    const double s = x.get_d();
    return (d == up ? x > mpq_class(s) : x < mpq_class(s)) ? outward(d, s, false) : s;
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
