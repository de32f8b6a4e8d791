#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>

#include "number/big_interval.hpp"
#include "number/integer.hpp"
#include "number/interval.hpp"

namespace dumbbell {

/// An exact rational in lowest terms (GMP): mass ratios and box coordinates. GMP's calls are out of line.
class Rational {  // NOLINT(cppcoreguidelines-special-member-functions): one assignment does both
  public:
    Rational() noexcept { mpq_init(q_); }
    template <std::integral T>
    Rational(T value) : Rational(Integer(value)) {}  // NOLINT(google-explicit-constructor)
    Rational(const Integer& value) : Rational() {    // NOLINT(google-explicit-constructor)
        mpq_set_z(q_, value.raw());
    }
    /// numerator / denominator. Throws BrokenInvariant if the denominator is 0.
    Rational(const Integer& numerator, const Integer& denominator);
    /// GMP's own. Precondition: in lowest terms.
    explicit Rational(mpq_srcptr value) : Rational() { mpq_set(q_, value); }
    Rational(const Rational& other) : Rational(other.q_) {}
    /// What is moved from may only be assigned to or destroyed.
    Rational(Rational&& other) noexcept : q_{*other.q_} { other.q_->_mp_den._mp_d = nullptr; }
    Rational& operator=(Rational other) noexcept {
        mpq_swap(q_, other.q_);
        return *this;
    }
    ~Rational() {
        if (q_->_mp_den._mp_d != nullptr) {
            mpq_clear(q_);
        }
    }

    Rational& operator+=(const Rational& y) { return with(mpq_add, y); }
    Rational& operator-=(const Rational& y) { return with(mpq_sub, y); }
    Rational& operator*=(const Rational& y) { return with(mpq_mul, y); }
    /// Throws BrokenInvariant if y is 0.
    Rational& operator/=(const Rational& y);

    friend Rational operator+(Rational x, const Rational& y) { return std::move(x += y); }
    friend Rational operator-(Rational x, const Rational& y) { return std::move(x -= y); }
    friend Rational operator*(Rational x, const Rational& y) { return std::move(x *= y); }
    friend Rational operator/(Rational x, const Rational& y) { return std::move(x /= y); }
    friend Rational operator-(Rational x) {
        mpq_neg(x.q_, x.q_);
        return x;
    }
    friend bool operator==(const Rational& x, const Rational& y) { return mpq_equal(x.q_, y.q_) != 0; }
    friend std::strong_ordering operator<=>(const Rational& x, const Rational& y) {
        return mpq_cmp(x.q_, y.q_) <=> 0;
    }
    friend std::ostream& operator<<(std::ostream& out, const Rational& x);

    /// double or long double, rounded to nearest, ties to even; int or long, towards zero (precondition: it
    /// fits).
    template <class T>
    [[nodiscard]] T convert_to() const;

    /// GMP's own, for calls of GMP and MPFR. What is written there must be in lowest terms.
    [[nodiscard]] mpq_ptr raw() { return q_; }
    [[nodiscard]] mpq_srcptr raw() const { return q_; }

  private:
    Rational& with(void (*operation)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Rational& y);

    mpq_t q_;
};

template <>
[[nodiscard]] double Rational::convert_to<double>() const;
template <>
[[nodiscard]] long double Rational::convert_to<long double>() const;
template <>
[[nodiscard]] int Rational::convert_to<int>() const;
template <>
[[nodiscard]] long Rational::convert_to<long>() const;

[[nodiscard]] Integer numerator(const Rational& x);
[[nodiscard]] Integer denominator(const Rational& x);
[[nodiscard]] Rational abs(Rational x);

inline constexpr std::size_t longest_number = 2100;  ///< characters of one that a user gives

/// A decimal, [0-9]+(.[0-9]+)?([eE][+-]?[0-9]+)?, a power 10^[+-]?[0-9]+, or a fraction, INT/INT, exactly.
/// Throws InputError (naming the text) for anything else, more than 2,100 characters, |exponent| > 1000, or a
/// zero denominator.
[[nodiscard]] Rational parse_rational(std::string_view text, std::size_t max_length = longest_number);
/// The same, with a minus before it or without.
[[nodiscard]] Rational parse_signed_rational(std::string_view text);

/// A user's text as it may stand in a message: on one line, and its first 40 bytes only.
[[nodiscard]] std::string shortened(std::string_view text);
/// With minus signs, pi and degrees as they are typed: those of a book (U+2212, U+03C0, U+00B0) are pasted
/// from there.
[[nodiscard]] std::string as_typed(std::string_view text);

/// `p/q` in lowest terms, with `/1` for integers.
[[nodiscard]] std::string to_fraction(const Rational& x);

/// A decimal of at most `digits` significant digits for people, e.g. `4.60334`; rounded to nearest.
[[nodiscard]] std::string to_decimal(const Rational& x, int digits);

/// The tightest enclosure of x in I.
template <class I>
[[nodiscard]] I enclose(const Rational& x);
template <>
[[nodiscard]] Interval enclose<Interval>(const Rational& x);
template <>
[[nodiscard]] BigInterval enclose<BigInterval>(const Rational& x);

/// 2^-n. Precondition: n >= 0.
[[nodiscard]] inline Rational power_of_half(int n) { return Rational(1, Integer(1) << n); }

/// The exact value of a finite double.
[[nodiscard]] Rational exact(double x);

/// The exact ends of X. Throws BrokenInvariant if they are not finite.
[[nodiscard]] inline Rational exact_lo(const Interval& x) { return exact(x.lo()); }
[[nodiscard]] Rational exact_lo(const BigInterval& x);
[[nodiscard]] Rational exact_hi(const BigInterval& x);

}  // namespace dumbbell
