#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <limits>

#include "rooms/number/tightest.hpp"

/// Exact ranges by MPFR, in enough more bits than the attacked layer for comparisons to be exact: a
/// number of the layer is at most t iff it is at most t rounded down to more bits.
namespace dumbbell_test {

/// The two ends of an interval, as numbers of the attacked layer.
struct Ends {
    explicit Ends(int bits) : lo(bits, 0), hi(bits, 0) {}
    Ends(int bits, double a, double b) : lo(bits, a), hi(bits, b) {}

    [[nodiscard]] bool holds_zero() { return mpfr_sgn(mpfr_ptr(lo)) <= 0 && mpfr_sgn(mpfr_ptr(hi)) >= 0; }

    Mpfr lo;
    Mpfr hi;
};

/// The hull of exact values, each rounded outward to `bits`.
class Hull {
  public:
    explicit Hull(int bits)
        : lo_(bits, std::numeric_limits<double>::infinity()),
          hi_(bits, -std::numeric_limits<double>::infinity()),
          value_(bits, 0) {}

    /// Adds a value: compute(destination, rounding) is one MPFR call.
    template <class Compute>
    void add(const Compute& compute) {
        compute(static_cast<mpfr_ptr>(value_), MPFR_RNDD);
        mpfr_min(lo_, lo_, value_, MPFR_RNDD);
        compute(static_cast<mpfr_ptr>(value_), MPFR_RNDU);
        mpfr_max(hi_, hi_, value_, MPFR_RNDU);
    }
    void add(int n) {
        add([n](mpfr_ptr to, mpfr_rnd_t rounding) { mpfr_set_si(to, n, rounding); });
    }

    [[nodiscard]] mpfr_ptr lo() { return lo_; }
    [[nodiscard]] mpfr_ptr hi() { return hi_; }

  private:
    Mpfr lo_;
    Mpfr hi_;
    Mpfr value_;
};

/// The range of an operation that is monotone in each argument.
inline void add_corners(Hull& hull, BinaryMpfr op, Ends& x, Ends& y) {
    for (mpfr_ptr a : {mpfr_ptr(x.lo), mpfr_ptr(x.hi)}) {
        for (mpfr_ptr b : {mpfr_ptr(y.lo), mpfr_ptr(y.hi)}) {
            hull.add([&](mpfr_ptr to, mpfr_rnd_t rounding) { op(to, a, b, rounding); });
        }
    }
}

/// The values of a function at both ends: its range, where it is monotone.
inline void add_ends(Hull& hull, UnaryMpfr f, Ends& x) {
    for (mpfr_ptr a : {mpfr_ptr(x.lo), mpfr_ptr(x.hi)}) {
        hull.add([&](mpfr_ptr to, mpfr_rnd_t rounding) { f(to, a, rounding); });
    }
}

/// The integer next to x / (pi/2), downwards or upwards. No number in binary but 0 is a multiple of pi/2, and
/// with as many bits none seems to be one.
inline mpz_class quarter_turns(mpfr_ptr x, mpfr_rnd_t direction) {
    mpz_class turns;
    if (mpfr_zero_p(x) == 0) {
        Mpfr quotient(static_cast<int>(200 + 2 * mpfr_get_prec(x) + std::max(0L, mpfr_get_exp(x))), 0);
        mpfr_const_pi(quotient, MPFR_RNDN);
        mpfr_div_2ui(quotient, quotient, 1, MPFR_RNDN);
        mpfr_div(quotient, x, quotient, MPFR_RNDN);
        mpfr_get_z(turns.get_mpz_t(), quotient, direction);
    }
    return turns;
}

/// The range of sine (at_peak = 1) or cosine (at_peak = 0): the values at the ends, and the extrema between.
/// `at_peak` is the number of quarter turns of a maximum.
inline void add_wave(Hull& hull, UnaryMpfr f, int at_peak, Ends& x) {
    if (mpfr_inf_p(mpfr_ptr(x.lo)) != 0 || mpfr_inf_p(mpfr_ptr(x.hi)) != 0) {
        hull.add(-1);
        hull.add(1);
        return;
    }
    add_ends(hull, f, x);
    const mpz_class first = quarter_turns(x.lo, MPFR_RNDU);
    const mpz_class last = quarter_turns(x.hi, MPFR_RNDD);
    for (mpz_class k = first; k <= last && k < first + 4; ++k) {
        const unsigned long phase = mpz_fdiv_ui(mpz_class(k - at_peak).get_mpz_t(), 4);
        if (phase % 2 == 0) {
            hull.add(phase == 0 ? 1 : -1);
        }
    }
}

}  // namespace dumbbell_test
