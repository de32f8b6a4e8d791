#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <type_traits>
#include <utility>

namespace dumbbell {

/// An exact integer (GMP), with GMP's calls out of line: this header is in nearly every source file.
class Integer {  // NOLINT(cppcoreguidelines-special-member-functions): one assignment does both
  public:
    Integer() noexcept { mpz_init(z_); }
    template <std::integral T>
    Integer(T value) {                             // NOLINT(google-explicit-constructor): no value is lost
        if constexpr (sizeof(T) > sizeof(long)) {  // of which GMP has no calls
            mpz_init_set(
                z_, Integer(std::conditional_t<std::is_signed_v<T>, long, unsigned long>(value >> 32)).z_);
            *this <<= 32;
            mpz_add_ui(z_, z_, static_cast<std::uint32_t>(value));
        } else if constexpr (std::is_signed_v<T>) {
            mpz_init_set_si(z_, value);
        } else {
            mpz_init_set_ui(z_, value);
        }
    }
    /// Of decimal digits, with or without a sign. Precondition: they are such.
    explicit Integer(const std::string& digits);
    Integer(const Integer& other) { mpz_init_set(z_, other.z_); }
    Integer(Integer&& other) noexcept : Integer() { mpz_swap(z_, other.z_); }
    Integer& operator=(Integer other) noexcept {
        mpz_swap(z_, other.z_);
        return *this;
    }
    ~Integer() { mpz_clear(z_); }

    Integer& operator+=(const Integer& y) { return with(mpz_add, y); }
    Integer& operator-=(const Integer& y) { return with(mpz_sub, y); }
    Integer& operator*=(const Integer& y) { return with(mpz_mul, y); }
    /// Towards zero, as for built-in integers. Throws BrokenInvariant if y is 0.
    Integer& operator/=(const Integer& y);
    /// The remainder of that division, with the sign of this number. Throws BrokenInvariant if y is 0.
    Integer& operator%=(const Integer& y);
    Integer& operator++() { return *this += 1; }
    Integer& operator<<=(unsigned bits) { return with(mpz_mul_2exp, bits); }
    /// Rounded down. For x >= 0, x / 2^bits towards zero.
    Integer& operator>>=(unsigned bits) { return with(mpz_fdiv_q_2exp, bits); }

    friend Integer operator+(Integer x, const Integer& y) { return std::move(x += y); }
    friend Integer operator-(Integer x, const Integer& y) { return std::move(x -= y); }
    friend Integer operator*(Integer x, const Integer& y) { return std::move(x *= y); }
    friend Integer operator/(Integer x, const Integer& y) { return std::move(x /= y); }
    friend Integer operator%(Integer x, const Integer& y) { return std::move(x %= y); }
    friend Integer operator<<(Integer x, unsigned bits) { return std::move(x <<= bits); }
    friend Integer operator>>(Integer x, unsigned bits) { return std::move(x >>= bits); }
    friend Integer operator-(Integer x) {
        mpz_neg(x.z_, x.z_);
        return x;
    }
    friend bool operator==(const Integer& x, const Integer& y) { return mpz_cmp(x.z_, y.z_) == 0; }
    friend std::strong_ordering operator<=>(const Integer& x, const Integer& y) {
        return mpz_cmp(x.z_, y.z_) <=> 0;
    }
    friend std::ostream& operator<<(std::ostream& out, const Integer& x);

    [[nodiscard]] std::string str() const;
    /// int or long. Precondition: it fits.
    template <std::integral T>
    [[nodiscard]] T convert_to() const {
        return static_cast<T>(mpz_get_si(z_));
    }

    /// GMP's own, for calls of GMP and MPFR.
    [[nodiscard]] mpz_ptr raw() { return z_; }
    [[nodiscard]] mpz_srcptr raw() const { return z_; }

  private:
    Integer& with(void (*operation)(mpz_ptr, mpz_srcptr, mpz_srcptr), const Integer& y);
    Integer& with(void (*operation)(mpz_ptr, mpz_srcptr, mp_bitcnt_t), unsigned bits);

    mpz_t z_;
};

[[nodiscard]] Integer pow(const Integer& base, unsigned exponent);
/// The places of the lowest and of the highest bit that is set. Precondition: x > 0.
[[nodiscard]] std::size_t lsb(const Integer& x);
[[nodiscard]] std::size_t msb(const Integer& x);

}  // namespace dumbbell
