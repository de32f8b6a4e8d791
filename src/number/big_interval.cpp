#include "number/big_interval.hpp"

#include "base/error.hpp"

namespace dumbbell {
namespace {

thread_local int working_bits = 128;

}  // namespace

PrecisionScope::PrecisionScope(int bits) : previous_(working_bits) {
    require(bits >= 2 && bits <= (1 << 20), "working precision out of range");
    working_bits = bits;
}
PrecisionScope::~PrecisionScope() { working_bits = previous_; }
int PrecisionScope::current() noexcept { return working_bits; }

BigInterval::BigInterval(double point) : BigInterval(point, point) {}
BigInterval::BigInterval(double lo, double hi) {
    mpfi_init2(value_, working_bits);
    mpfi_interv_d(value_, lo, hi);
}
BigInterval::BigInterval(const BigInterval& other) {
    mpfi_init2(value_, mpfi_get_prec(other.value_));
    mpfi_set(value_, other.value_);
}
BigInterval::BigInterval(BigInterval&& other) noexcept {
    // A moved-from value stays valid: it keeps a minimal allocation of its own.
    mpfi_init2(value_, MPFR_PREC_MIN);
    mpfi_swap(value_, other.value_);
}
BigInterval& BigInterval::operator=(const BigInterval& other) {
    if (this != &other) {
        mpfi_set_prec(value_, mpfi_get_prec(other.value_));
        mpfi_set(value_, other.value_);
    }
    return *this;
}
BigInterval& BigInterval::operator=(BigInterval&& other) noexcept {
    mpfi_swap(value_, other.value_);
    return *this;
}
BigInterval::~BigInterval() { mpfi_clear(value_); }

double BigInterval::lo() const { return mpfr_get_d(&value_->left, MPFR_RNDD); }
double BigInterval::hi() const { return mpfr_get_d(&value_->right, MPFR_RNDU); }

BigInterval operator+(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    mpfi_add(result.raw(), a.raw(), b.raw());
    return result;
}
BigInterval operator-(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    mpfi_sub(result.raw(), a.raw(), b.raw());
    return result;
}
BigInterval operator*(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    mpfi_mul(result.raw(), a.raw(), b.raw());
    return result;
}
BigInterval operator/(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    mpfi_div(result.raw(), a.raw(), b.raw());
    return result;
}
BigInterval operator-(const BigInterval& a) {
    BigInterval result;
    mpfi_neg(result.raw(), a.raw());
    return result;
}
BigInterval sqr(const BigInterval& a) {
    BigInterval result;
    mpfi_sqr(result.raw(), a.raw());
    return result;
}
BigInterval sqrt(const BigInterval& a) {
    BigInterval result;
    mpfi_sqrt(result.raw(), max(a, BigInterval(0)).raw());
    return result;
}
BigInterval hull(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    mpfi_union(result.raw(), a.raw(), b.raw());
    return result;
}
BigInterval min(const BigInterval& a, const BigInterval& b) { return -max(-a, -b); }
BigInterval max(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    if (mpfi_nan_p(a.raw()) != 0 || mpfi_nan_p(b.raw()) != 0) {
        mpfr_set_nan(&result.raw()->left);  // mpfr_max would take the other operand
        mpfr_set_nan(&result.raw()->right);
        return result;
    }
    mpfr_max(&result.raw()->left, &a.raw()->left, &b.raw()->left, MPFR_RNDD);
    mpfr_max(&result.raw()->right, &a.raw()->right, &b.raw()->right, MPFR_RNDU);
    return result;
}

namespace {

/// The interval whose lower end `value.left` is an exact value rounded down: thin if the rounding lost
/// nothing.
void close_above(mpfi_ptr value, bool rounded) {
    mpfr_set(&value->right, &value->left, MPFR_RNDU);
    if (rounded) {
        mpfr_nextabove(&value->right);
    }
}

}  // namespace

SinCos<BigInterval> sin_cos(const BigInterval& x) {
    SinCos<BigInterval> result;
    if (mpfr_number_p(&x.raw()->left) != 0 && mpfr_equal_p(&x.raw()->left, &x.raw()->right) != 0) {
        // One correctly rounded evaluation instead of MPFI's eight; the ends are the same. The two low bits
        // of the answer are 0 iff the sine is exact, the next two iff the cosine is.
        const int inexact =
            mpfr_sin_cos(&result.sin.raw()->left, &result.cos.raw()->left, &x.raw()->left, MPFR_RNDD);
        close_above(result.sin.raw(), (inexact & 3) != 0);
        close_above(result.cos.raw(), (inexact >> 2) != 0);
        return result;
    }
    mpfi_sin(result.sin.raw(), x.raw());
    mpfi_cos(result.cos.raw(), x.raw());
    return result;
}
BigInterval asin(const BigInterval& x) {
    BigInterval result;
    mpfi_asin(result.raw(), min(max(x, BigInterval(-1)), BigInterval(1)).raw());
    return result;
}
template <>
BigInterval pi<BigInterval>() {
    BigInterval result;
    mpfi_const_pi(result.raw());
    return result;
}
template <>
BigInterval half_pi<BigInterval>() {
    BigInterval result = pi<BigInterval>();
    mpfi_div_2ui(result.raw(), result.raw(), 1);
    return result;
}

BigInterval low_end(const BigInterval& x) {
    BigInterval result;
    mpfr_set(&result.raw()->left, &x.raw()->left, MPFR_RNDD);
    mpfr_set(&result.raw()->right, &result.raw()->left, MPFR_RNDU);
    return result;
}
BigInterval high_end(const BigInterval& x) {
    BigInterval result;
    mpfr_set(&result.raw()->right, &x.raw()->right, MPFR_RNDU);
    mpfr_set(&result.raw()->left, &result.raw()->right, MPFR_RNDD);
    return result;
}
// mpfr_less_p and its like are false for NaN.
bool certainly_less(const BigInterval& x, const BigInterval& y) {
    return mpfr_less_p(&x.raw()->right, &y.raw()->left) != 0;
}
bool certainly_at_most(const BigInterval& x, const BigInterval& y) {
    return mpfr_lessequal_p(&x.raw()->right, &y.raw()->left) != 0;
}
bool certainly_positive(const BigInterval& x) {
    return !mpfr_nan_p(&x.raw()->left) && mpfr_sgn(&x.raw()->left) > 0;
}

double approximate(const BigInterval& x) { return mpfi_get_d(x.raw()); }
double width(const BigInterval& x) {
    BigInterval diameter;
    mpfr_sub(&diameter.raw()->right, &x.raw()->right, &x.raw()->left, MPFR_RNDU);
    return diameter.hi();
}
BigInterval midpoint(const BigInterval& x) {
    BigInterval result;
    mpfi_mid(&result.raw()->left, x.raw());
    mpfr_set(&result.raw()->right, &result.raw()->left, MPFR_RNDU);
    return result;
}

void forget_thread_constants() { mpfr_free_cache(); }

}  // namespace dumbbell
