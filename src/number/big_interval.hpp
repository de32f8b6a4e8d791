#pragma once

#include <limits>

#include "number/elementary.hpp"
#include "number/flint.hpp"

namespace dumbbell {

/// An interval with ends of any precision (Arb's arf_t): the same vocabulary as Interval, for escalation and
/// as the oracle in tests. An operation rounds the ends of its result outward to the calling thread's working
/// precision, see PrecisionScope; every result here is the tightest one, sine, cosine and the like included.
/// Copies and intervals of doubles are exact.
class BigInterval {
  public:
    BigInterval() {
        arf_init(lo_);
        arf_init(hi_);
    }
    explicit BigInterval(double point) : BigInterval(point, point) {}
    /// NaN unless lo <= hi.
    BigInterval(double lo, double hi) : BigInterval() {
        const bool in_order = lo <= hi;
        arf_set_d(lo_, in_order ? lo : nan);
        arf_set_d(hi_, in_order ? hi : nan);
    }
    BigInterval(const BigInterval& other) : BigInterval() {
        arf_set(lo_, other.lo_);
        arf_set(hi_, other.hi_);
    }
    BigInterval(BigInterval&& other) noexcept : BigInterval() { swap(other); }
    BigInterval& operator=(const BigInterval& other) {
        arf_set(lo_, other.lo_);
        arf_set(hi_, other.hi_);
        return *this;
    }
    BigInterval& operator=(BigInterval&& other) noexcept {
        swap(other);
        return *this;
    }
    ~BigInterval();

    /// The bounds, rounded outward to double.
    [[nodiscard]] double lo() const { return arf_get_d(lo_, ARF_RND_FLOOR); }
    [[nodiscard]] double hi() const { return arf_get_d(hi_, ARF_RND_CEIL); }

    /// The bounds, for calls of Arb. What writes one writes both: lower <= upper, or both NaN.
    [[nodiscard]] arf_srcptr lower() const noexcept { return lo_; }
    [[nodiscard]] arf_srcptr upper() const noexcept { return hi_; }
    [[nodiscard]] arf_ptr lower() noexcept { return lo_; }
    [[nodiscard]] arf_ptr upper() noexcept { return hi_; }

  private:
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    void swap(BigInterval& other) noexcept {
        arf_swap(lo_, other.lo_);
        arf_swap(hi_, other.hi_);
    }

    arf_t lo_, hi_;
};

/// The precision of double, as PrecisionScope counts it.
inline constexpr int double_bits = 53;

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
/// The whole line if 0 is in `b`.
[[nodiscard]] BigInterval operator/(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval operator-(const BigInterval& a);
[[nodiscard]] BigInterval sqr(const BigInterval& a);
/// Of the part of `a` that is >= 0; 0 if there is none.
[[nodiscard]] BigInterval sqrt(const BigInterval& a);
[[nodiscard]] BigInterval hull(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval min(const BigInterval& a, const BigInterval& b);
[[nodiscard]] BigInterval max(const BigInterval& a, const BigInterval& b);

[[nodiscard]] SinCos<BigInterval> sin_cos(const BigInterval& x);
[[nodiscard]] BigInterval asin(const BigInterval& x);
/// The natural logarithm; NaN unless x is finite and certainly positive.
[[nodiscard]] BigInterval log(const BigInterval& x);
template <>
[[nodiscard]] BigInterval pi<BigInterval>();
template <>
[[nodiscard]] BigInterval half_pi<BigInterval>();

/// 2^exponent, exactly.
[[nodiscard]] BigInterval two_to(long exponent);

[[nodiscard]] BigInterval low_end(const BigInterval& x);
[[nodiscard]] BigInterval high_end(const BigInterval& x);
[[nodiscard]] bool certainly_less(const BigInterval& x, const BigInterval& y);
[[nodiscard]] bool certainly_at_most(const BigInterval& x, const BigInterval& y);
[[nodiscard]] bool certainly_positive(const BigInterval& x);
[[nodiscard]] double approximate(const BigInterval& x);
[[nodiscard]] double width(const BigInterval& x);
/// A thin interval near the middle of X: for guesses only.
[[nodiscard]] BigInterval midpoint(const BigInterval& x);

}  // namespace dumbbell
