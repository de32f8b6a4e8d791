#pragma once

#include "number/big_interval.hpp"
#include "number/count.hpp"
#include "number/flint.hpp"

/// Arb's balls and polynomials, as values. Every operation works at the precision of the thread's
/// PrecisionScope.
namespace dumbbell::flight::macro {

inline slong bits() { return PrecisionScope::current(); }

/// A real number known to lie in a ball.
class Ball {
  public:
    Ball() { arb_init(value_); }
    explicit Ball(double x) : Ball() { arb_set_d(value_, x); }
    explicit Ball(const BigInterval& x) : Ball() {
        arb_set_interval_arf(value_, x.lower(), x.upper(), bits());
    }
    explicit Ball(arb_srcptr x) : Ball() { arb_set(value_, x); }
    Ball(const Ball& other) : Ball(other.value_) {}
    Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
    Ball& operator=(const Ball& other) { return *this = Ball(other); }
    Ball& operator=(Ball&& other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~Ball() { arb_clear(value_); }

    [[nodiscard]] arb_ptr raw() { return value_; }
    [[nodiscard]] arb_srcptr raw() const { return value_; }

    friend Ball operator+(const Ball& a, const Ball& b) { return made(arb_add, a, b); }
    friend Ball operator-(const Ball& a, const Ball& b) { return made(arb_sub, a, b); }
    friend Ball operator*(const Ball& a, const Ball& b) { return made(arb_mul, a, b); }
    friend Ball operator/(const Ball& a, const Ball& b) { return made(arb_div, a, b); }

  private:
    static Ball made(void (*function)(arb_ptr, arb_srcptr, arb_srcptr, slong), const Ball& a, const Ball& b) {
        Ball result;
        function(result.value_, a.value_, b.value_, bits());
        return result;
    }

    arb_t value_;
};

inline Ball whole(long n) {
    Ball result;
    arb_set_si(result.raw(), n);
    return result;
}
inline Ball whole(const Count& n) {
    Ball result;
    arf_set_mpz(arb_midref(result.raw()), n.integer().raw());
    return result;
}
inline bool positive(const Ball& x) { return arb_is_positive(x.raw()) != 0; }
inline double approximate(const Ball& x) { return arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR); }

inline Ball middle(const Ball& x) {
    Ball result;
    arb_get_mid_arb(result.raw(), x.raw());
    return result;
}
/// A number that is certainly not less (`up`), or not greater, than any of the ball.
inline Ball end(const Ball& x, bool up) {
    Ball result;
    (up ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(result.raw()), x.raw(), bits());
    return result;
}
inline Ball power_of_two(long exponent) {
    Ball result(1);
    arb_mul_2exp_si(result.raw(), result.raw(), exponent);
    return result;
}
inline Ball pi() {
    Ball result;
    arb_const_pi(result.raw(), bits());
    return result;
}

/// An upper bound of the ball's numbers' sizes.
inline Ball greatest_size(const Ball& x) {
    Ball result;
    arb_get_abs_ubound_arf(arb_midref(result.raw()), x.raw(), bits());
    return result;
}

/// A polynomial with balls as coefficients, or a power series cut off.
class Series {
  public:
    Series() { arb_poly_init(value_); }
    Series(const Series& other) : Series() { arb_poly_set(value_, other.value_); }
    Series(Series&& other) noexcept : Series() { arb_poly_swap(value_, other.value_); }
    Series& operator=(const Series& other) { return *this = Series(other); }
    Series& operator=(Series&& other) noexcept {
        arb_poly_swap(value_, other.value_);
        return *this;
    }
    ~Series() { arb_poly_clear(value_); }

    [[nodiscard]] arb_poly_struct* raw() { return value_; }
    [[nodiscard]] const arb_poly_struct* raw() const { return value_; }

    [[nodiscard]] Ball operator[](slong i) const {
        Ball result;
        arb_poly_get_coeff_arb(result.raw(), value_, i);
        return result;
    }
    [[nodiscard]] Ball at(const Ball& s) const {
        Ball result;
        arb_poly_evaluate(result.raw(), value_, s.raw(), bits());
        return result;
    }
    void set(slong i, const Ball& x) { arb_poly_set_coeff_arb(value_, i, x.raw()); }
    /// The same with x added to coefficient 0.
    [[nodiscard]] Series plus(const Ball& x) const {
        Series result = *this;
        result.set(0, (*this)[0] + x);
        return result;
    }
    [[nodiscard]] Series times(const Ball& x) const {
        Series result;
        arb_poly_scalar_mul(result.value_, value_, x.raw(), bits());
        return result;
    }
    /// The product's terms of degree < `length`.
    [[nodiscard]] Series times(const Series& other, slong length) const {
        Series result;
        arb_poly_mullow(result.value_, value_, other.value_, length, bits());
        return result;
    }
    [[nodiscard]] Series derivative() const {
        Series result;
        arb_poly_derivative(result.value_, value_, bits());
        return result;
    }
    friend Series operator+(const Series& a, const Series& b) {
        Series result;
        arb_poly_add(result.value_, a.value_, b.value_, bits());
        return result;
    }
    friend Series operator-(const Series& a, const Series& b) {
        Series result;
        arb_poly_sub(result.value_, a.value_, b.value_, bits());
        return result;
    }

  private:
    arb_poly_t value_;
};

/// An upper bound of the sum of the sizes of the coefficients from degree `first` on: of the polynomial's
/// size on [-1, 1], without its lower terms.
inline Ball size_from(const Series& p, slong first) {
    mag_t sum, term;
    mag_init(sum);
    mag_init(term);
    for (slong i = first; i < p.raw()->length; ++i) {
        arb_get_mag(term, p.raw()->coeffs + i);
        mag_add(sum, sum, term);
    }
    Ball result;
    arf_set_mag(arb_midref(result.raw()), sum);
    mag_clear(sum);
    mag_clear(term);
    return result;
}

}  // namespace dumbbell::flight::macro
