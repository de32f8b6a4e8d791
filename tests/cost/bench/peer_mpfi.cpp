#include <mpfi.h>

#include "peers.hpp"

namespace dumbbell_bench {
namespace {

/// An interval of MPFI as its user writes it: a class around mpfi_t, and MPFI's own sine and cosine.
class Mpfi {
  public:
    Mpfi() { mpfi_init2(value_, dumbbell::PrecisionScope::current()); }
    explicit Mpfi(double point) : Mpfi() { mpfi_set_d(value_, point); }
    explicit Mpfi(const dumbbell::BigInterval& x) : Mpfi() {
        arf_get_mpfr(&value_->left, x.lower(), MPFR_RNDD);
        arf_get_mpfr(&value_->right, x.upper(), MPFR_RNDU);
    }
    Mpfi(const Mpfi& other) : Mpfi() { mpfi_set(value_, other.value_); }
    Mpfi(Mpfi&& other) noexcept : Mpfi() { mpfi_swap(value_, other.value_); }
    Mpfi& operator=(const Mpfi& other) {
        mpfi_set(value_, other.value_);
        return *this;
    }
    Mpfi& operator=(Mpfi&& other) noexcept {
        mpfi_swap(value_, other.value_);
        return *this;
    }
    ~Mpfi() { mpfi_clear(value_); }

    [[nodiscard]] mpfi_srcptr raw() const { return value_; }
    [[nodiscard]] mpfi_ptr raw() { return value_; }
    [[nodiscard]] mpfr_srcptr low() const { return &value_->left; }
    [[nodiscard]] mpfr_srcptr high() const { return &value_->right; }

  private:
    mpfi_t value_;
};

/// Of any function of MPFI, or of mpfr numbers.
template <class Function, class... Arguments>
Mpfi result_of(Function function, Arguments... arguments) {
    Mpfi result;
    function(result.raw(), arguments...);
    return result;
}
Mpfi operator+(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_add, a.raw(), b.raw()); }
Mpfi operator-(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_sub, a.raw(), b.raw()); }
Mpfi operator*(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_mul, a.raw(), b.raw()); }
Mpfi operator/(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_div, a.raw(), b.raw()); }
Mpfi operator-(const Mpfi& a) { return result_of(mpfi_neg, a.raw()); }
Mpfi sqr(const Mpfi& a) { return result_of(mpfi_sqr, a.raw()); }
Mpfi hull(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_union, a.raw(), b.raw()); }
Mpfi low_end(const Mpfi& a) { return result_of(mpfi_set_fr, a.low()); }
Mpfi high_end(const Mpfi& a) { return result_of(mpfi_set_fr, a.high()); }
Mpfi max(const Mpfi& a, const Mpfi& b) {
    return result_of(mpfi_interv_fr, mpfr_less_p(a.low(), b.low()) != 0 ? b.low() : a.low(),
                     mpfr_less_p(a.high(), b.high()) != 0 ? b.high() : a.high());
}
dumbbell::SinCos<Mpfi> sin_cos(const Mpfi& a) {
    return {result_of(mpfi_sin, a.raw()), result_of(mpfi_cos, a.raw())};
}
bool certainly_less(const Mpfi& a, const Mpfi& b) { return mpfr_less_p(a.high(), b.low()) != 0; }
bool certainly_at_most(const Mpfi& a, const Mpfi& b) { return mpfr_lessequal_p(a.high(), b.low()) != 0; }
bool certainly_positive(const Mpfi& a) { return mpfr_sgn(a.low()) > 0; }
double approximate(const Mpfi& a) { return mpfi_get_d(a.raw()); }
dumbbell::BigInterval as_big(const Mpfi& a) {
    dumbbell::BigInterval result;
    arf_set_mpfr(result.lower(), a.low());
    arf_set_mpfr(result.upper(), a.high());
    return result;
}
dumbbell::flight::ContactGuess<Mpfi> guess_contact(const Mpfi& c, const Mpfi& kappa, double start) {
    return guess_for(c, kappa, start);
}

}  // namespace
}  // namespace dumbbell_bench

using namespace dumbbell_bench;

template <>
Mpfi dumbbell::pi() {
    return result_of(mpfi_const_pi);
}
template <>
Mpfi dumbbell::half_pi() {
    return result_of(mpfi_div_ui, pi<Mpfi>().raw(), 2);
}
template <>
Mpfi dumbbell::flight::detail::least_step() {
    return Mpfi(two_to(-1000 - PrecisionScope::current()));
}

Arithmetic dumbbell_bench::mpfi() { return arithmetic<Mpfi, NoScope>("MPFI"); }
