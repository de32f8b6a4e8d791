#pragma once

#include <mpfi.h>

#include "number/elementary.hpp"

namespace dumbbell {

/// An interval with MPFR bounds of any precision (MPFI): the same vocabulary as Interval, for escalation and
/// as the oracle in tests. New values get the calling thread's working precision, see PrecisionScope.
class BigInterval {
  public:
    BigInterval() : BigInterval(0.0) {}
    explicit BigInterval(double point);
    BigInterval(double lo, double hi);
    BigInterval(const BigInterval& other);
    BigInterval(BigInterval&& other) noexcept;
    BigInterval& operator=(const BigInterval& other);
    BigInterval& operator=(BigInterval&& other) noexcept;
    ~BigInterval();

    /// The bounds, rounded outward to double.
    [[nodiscard]] double lo() const;
    [[nodiscard]] double hi() const;
    [[nodiscard]] mpfi_srcptr raw() const noexcept { return value_; }
    [[nodiscard]] mpfi_ptr raw() noexcept { return value_; }

  private:
    mpfi_t value_;
};

/// Sets the working precision (bits) of BigInterval on this thread for its lifetime. Precondition: 2 <= bits
/// <= 2^20.
class PrecisionScope {
  public:
    explicit PrecisionScope(int bits);
    ~PrecisionScope();
    PrecisionScope(const PrecisionScope&) = delete;
    PrecisionScope& operator=(const PrecisionScope&) = delete;

    /// Of the calling thread; 128 outside every scope.
    [[nodiscard]] static int current() noexcept;

  private:
    int previous_;
};

[[nodiscard]] BigInterval operator+(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval operator-(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval operator*(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval operator/(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval operator-(const BigInterval& a);
[[nodiscard]] BigInterval sqr(const BigInterval& a);
[[nodiscard]] BigInterval sqrt(const BigInterval& a);
[[nodiscard]] BigInterval hull(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval min(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval max(const BigInterval& a, const BigInterval& b);

[[nodiscard]] SinCos<BigInterval> sin_cos(const BigInterval& x);
[[nodiscard]] BigInterval asin(const BigInterval& x);
template <>
[[nodiscard]] BigInterval pi<BigInterval>();
template <>
[[nodiscard]] BigInterval half_pi<BigInterval>();

[[nodiscard]] BigInterval low_end(const BigInterval& x);
[[nodiscard]] BigInterval high_end(const BigInterval& x);
[[nodiscard]] bool certainly_less(const BigInterval& x, const BigInterval& y);
[[nodiscard]] bool certainly_at_most(const BigInterval& x, const BigInterval& y);
[[nodiscard]] bool certainly_positive(const BigInterval& x);
[[nodiscard]] double approximate(const BigInterval& x);
[[nodiscard]] double width(const BigInterval& x);
/// A thin interval near the middle of X: for guesses only.
[[nodiscard]] BigInterval midpoint(const BigInterval& x);

/// MPFR keeps pi and its like for each thread that used them. A thread of one's own calls this before it
/// ends, or their memory is lost.
void forget_thread_constants();

}  // namespace dumbbell
