#pragma once

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "number/interval.hpp"
#include "show.hpp"

/// What MPFR says: the tightest enclosures in doubles, against which the interval layer is held.
namespace dumbbell_test {

/// One MPFR number.
class Mpfr {
  public:
    Mpfr() : Mpfr(53, 0) {}
    explicit Mpfr(double x) : Mpfr(53, x) {}
    Mpfr(int bits, double x) {
        mpfr_init2(value_, bits);
        mpfr_set_d(value_, x, MPFR_RNDN);
    }
    Mpfr(const Mpfr&) = delete;
    Mpfr& operator=(const Mpfr&) = delete;
    ~Mpfr() { mpfr_clear(value_); }
    operator mpfr_ptr() { return value_; }

  private:
    mpfr_t value_;
};

/// The hull of exact results, rounded outward to double: an Interval encloses the results iff it contains
/// this.
struct Tightest {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    /// Adds a result: compute(rounding, destination) is one MPFR call, correctly rounded.
    template <class Compute>
    void add(const Compute& compute) {
        static thread_local Mpfr result;
        compute(static_cast<mpfr_ptr>(result), MPFR_RNDD);
        lo = std::min(lo, mpfr_get_d(result, MPFR_RNDD));
        compute(static_cast<mpfr_ptr>(result), MPFR_RNDU);
        hi = std::max(hi, mpfr_get_d(result, MPFR_RNDU));
    }
};

using BinaryMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
using UnaryMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// The value of an operation at one point.
inline Tightest at_point(UnaryMpfr op, double x) {
    Tightest value;
    Mpfr argument(x);
    value.add([&](mpfr_ptr to, mpfr_rnd_t rounding) { op(to, argument, rounding); });
    return value;
}

inline bool encloses(const dumbbell::Interval& x, const Tightest& exact) {
    return x.lo() <= exact.lo && exact.hi <= x.hi();
}

/// The number of doubles from a to b, a <= b; the largest int64 where it does not fit (from -inf to +inf,
/// say).
inline std::int64_t ulps_between(double a, double b) {
    const auto rank = [](double v) {
        const auto bits = std::bit_cast<std::int64_t>(v);
        return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
    };
    std::int64_t count = 0;
    return __builtin_sub_overflow(rank(b), rank(a), &count) ? std::numeric_limits<std::int64_t>::max()
                                                            : count;
}

/// By how many doubles the enclosure is too wide, at its worse end.
inline std::int64_t excess(const dumbbell::Interval& x, const Tightest& exact) {
    return std::max(ulps_between(x.lo(), exact.lo), ulps_between(exact.hi, x.hi()));
}

inline std::string show(const Tightest& x) { return fmt::format("[{:a}, {:a}]", x.lo, x.hi); }

}  // namespace dumbbell_test
