#include <mpfi.h>

#include "peer_kernel.hpp"

namespace dumbbell_bench {
namespace {

/// A number of MPFI as its user writes it: a class around mpfi_t, and MPFI's own sine and cosine.
class Mpfi {
  public:
    Mpfi() { mpfi_init2(value_, 53); }
    explicit Mpfi(double point) : Mpfi() { mpfi_set_d(value_, point); }
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

  private:
    mpfi_t value_;
};

Mpfi result_of(int (*operation)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr), const Mpfi& a, const Mpfi& b) {
    Mpfi result;
    operation(result.raw(), a.raw(), b.raw());
    return result;
}
Mpfi result_of(int (*operation)(mpfi_ptr, mpfi_srcptr), const Mpfi& a) {
    Mpfi result;
    operation(result.raw(), a.raw());
    return result;
}
Mpfi operator+(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_add, a, b); }
Mpfi operator-(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_sub, a, b); }
Mpfi operator*(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_mul, a, b); }
Mpfi operator/(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_div, a, b); }
Mpfi hull(const Mpfi& a, const Mpfi& b) { return result_of(mpfi_union, a, b); }
Mpfi operator-(const Mpfi& a) { return result_of(mpfi_neg, a); }
Mpfi sqr(const Mpfi& a) { return result_of(mpfi_sqr, a); }
dumbbell::SinCos<Mpfi> sin_cos(const Mpfi& a) { return {result_of(mpfi_sin, a), result_of(mpfi_cos, a)}; }

Mpfi max(const Mpfi& a, const Mpfi& b) {
    Mpfi result;
    mpfr_max(&result.raw()->left, &a.raw()->left, &b.raw()->left, MPFR_RNDD);
    mpfr_max(&result.raw()->right, &a.raw()->right, &b.raw()->right, MPFR_RNDU);
    return result;
}
Mpfi low_end(const Mpfi& a) {
    Mpfi result;
    mpfi_set_fr(result.raw(), &a.raw()->left);
    return result;
}
Mpfi high_end(const Mpfi& a) {
    Mpfi result;
    mpfi_set_fr(result.raw(), &a.raw()->right);
    return result;
}
bool certainly_less(const Mpfi& a, const Mpfi& b) {
    return mpfr_less_p(&a.raw()->right, &b.raw()->left) != 0;
}
bool certainly_at_most(const Mpfi& a, const Mpfi& b) {
    return mpfr_lessequal_p(&a.raw()->right, &b.raw()->left) != 0;
}
bool certainly_positive(const Mpfi& a) { return certainly_less(Mpfi(0), a); }
double approximate(const Mpfi& a) { return mpfi_get_d(a.raw()); }
dumbbell::flight::ContactGuess<Mpfi> guess_contact(const Mpfi& c, const Mpfi& kappa) {
    return double_guess(c, kappa);
}

}  // namespace
}  // namespace dumbbell_bench

template <>
dumbbell_bench::Mpfi dumbbell::pi() {
    dumbbell_bench::Mpfi result;
    mpfi_const_pi(result.raw());
    return result;
}
template <>
dumbbell_bench::Mpfi dumbbell::half_pi() {
    dumbbell_bench::Mpfi result = pi<dumbbell_bench::Mpfi>();
    mpfi_div_2ui(result.raw(), result.raw(), 1);
    return result;
}
template <>
dumbbell_bench::Mpfi dumbbell::flight::detail::least_step() {
    return dumbbell_bench::Mpfi(0x1p-1000);
}

const dumbbell_bench::Peer dumbbell_bench::mpfi{
    "MPFI",
    [](const dumbbell::flight::Ray<double>& ray, long most) {
        return dumbbell::flight::count_at_most(as_ray<Mpfi>(ray), most);
    },
    [](const dumbbell::flight::Ray<double>& ray, long most) {
        return dumbbell::flight::count_at_least(as_ray<Mpfi>(ray), most);
    }};
