#include <CGAL/Interval_nt.h>
#include <mpfr.h>

#include "number/elementary.hpp"
#include "peer_kernel.hpp"

namespace dumbbell_bench {
namespace {

using Unprotected = CGAL::Interval_nt<false>;  // its user keeps the rounding mode upward

/// Correctly rounded, from MPFR, of a point of [0, pi/2].
struct MpfrSine {
    static dumbbell::SinCos<Unprotected> at(double x) {
        static thread_local Scratch scratch;
        mpfr_set_d(scratch.x, x, MPFR_RNDN);  // exact
        mpfr_sin_cos(scratch.sin, scratch.cos, scratch.x, MPFR_RNDD);
        return {from_below(scratch.sin), from_below(scratch.cos)};
    }

  private:
    struct Scratch {
        mpfr_t x, sin, cos;
        Scratch() { mpfr_inits2(53, x, sin, cos, static_cast<mpfr_ptr>(nullptr)); }
        ~Scratch() { mpfr_clears(x, sin, cos, static_cast<mpfr_ptr>(nullptr)); }
        Scratch(const Scratch&) = delete;
        Scratch& operator=(const Scratch&) = delete;
    };
    static Unprotected from_below(mpfr_ptr low) {
        const double lo = mpfr_get_d(low, MPFR_RNDD);
        mpfr_nextabove(low);
        return {lo, mpfr_get_d(low, MPFR_RNDU)};
    }
};

/// This project's, for which the rounding mode has to be switched twice.
struct OwnSine {
    static dumbbell::SinCos<Unprotected> at(double x) {
        CGAL::FPU_set_cw(CGAL_FE_TONEAREST);
        const auto both = dumbbell::sin_cos(dumbbell::Interval(x));
        CGAL::FPU_set_cw(CGAL_FE_UPWARD);
        return {Unprotected(both.sin.lo(), both.sin.hi()), Unprotected(both.cos.lo(), both.cos.hi())};
    }
};

template <class Sine>
class Cgal {
  public:
    Cgal() = default;
    explicit Cgal(double point) : value_(point) {}
    explicit Cgal(const Unprotected& value) : value_(value) {}

    friend Cgal operator+(const Cgal& a, const Cgal& b) { return Cgal(a.value_ + b.value_); }
    friend Cgal operator-(const Cgal& a, const Cgal& b) { return Cgal(a.value_ - b.value_); }
    friend Cgal operator*(const Cgal& a, const Cgal& b) { return Cgal(a.value_ * b.value_); }
    friend Cgal operator/(const Cgal& a, const Cgal& b) { return Cgal(a.value_ / b.value_); }
    friend Cgal operator-(const Cgal& a) { return Cgal(-a.value_); }
    friend Cgal sqr(const Cgal& a) { return Cgal(CGAL::square(a.value_)); }
    friend Cgal max(const Cgal& a, const Cgal& b) {
        return Cgal(
            Unprotected(std::max(a.value_.inf(), b.value_.inf()), std::max(a.value_.sup(), b.value_.sup())));
    }
    friend Cgal hull(const Cgal& a, const Cgal& b) {
        return Cgal(
            Unprotected(std::min(a.value_.inf(), b.value_.inf()), std::max(a.value_.sup(), b.value_.sup())));
    }
    friend Cgal low_end(const Cgal& a) { return Cgal(a.value_.inf()); }
    friend Cgal high_end(const Cgal& a) { return Cgal(a.value_.sup()); }
    friend bool certainly_less(const Cgal& a, const Cgal& b) { return a.value_.sup() < b.value_.inf(); }
    friend bool certainly_at_most(const Cgal& a, const Cgal& b) { return a.value_.sup() <= b.value_.inf(); }
    friend bool certainly_positive(const Cgal& a) { return a.value_.inf() > 0; }
    friend double approximate(const Cgal& a) { return a.value_.inf(); }
    friend dumbbell::flight::ContactGuess<Cgal> guess_contact(const Cgal& c, const Cgal& kappa,
                                                              double start) {
        return double_guess(c, kappa, start);
    }
    /// Of a point: the kernel asks for no other.
    friend dumbbell::SinCos<Cgal> sin_cos(const Cgal& a) {
        const auto both = Sine::at(a.value_.inf());
        return {Cgal(both.sin), Cgal(both.cos)};
    }

  private:
    Unprotected value_;
};

template <class Sine>
long at_most(const dumbbell::flight::Ray<double>& ray, long most) {
    const CGAL::Protect_FPU_rounding<true> rounding(CGAL_FE_UPWARD);
    return dumbbell::flight::count_at_most(as_ray<Cgal<Sine>>(ray), most);
}
template <class Sine>
long at_least(const dumbbell::flight::Ray<double>& ray, long most) {
    const CGAL::Protect_FPU_rounding<true> rounding(CGAL_FE_UPWARD);
    return dumbbell::flight::count_at_least(as_ray<Cgal<Sine>>(ray), most);
}

using WithMpfr = Cgal<MpfrSine>;
using WithOwn = Cgal<OwnSine>;

Unprotected as_cgal(const dumbbell::Interval& x) { return {x.lo(), x.hi()}; }

}  // namespace
}  // namespace dumbbell_bench

template <>
dumbbell_bench::WithMpfr dumbbell::pi() {
    return dumbbell_bench::WithMpfr(dumbbell_bench::as_cgal(pi<Interval>()));
}
template <>
dumbbell_bench::WithOwn dumbbell::pi() {
    return dumbbell_bench::WithOwn(dumbbell_bench::as_cgal(pi<Interval>()));
}
template <>
dumbbell_bench::WithMpfr dumbbell::half_pi() {
    return dumbbell_bench::WithMpfr(dumbbell_bench::as_cgal(half_pi<Interval>()));
}
template <>
dumbbell_bench::WithOwn dumbbell::half_pi() {
    return dumbbell_bench::WithOwn(dumbbell_bench::as_cgal(half_pi<Interval>()));
}
template <>
dumbbell_bench::WithMpfr dumbbell::flight::detail::least_step() {
    return dumbbell_bench::WithMpfr(0x1p-1000);
}
template <>
dumbbell_bench::WithOwn dumbbell::flight::detail::least_step() {
    return dumbbell_bench::WithOwn(0x1p-1000);
}

const dumbbell_bench::Peer dumbbell_bench::cgal_with_mpfr_sine{"CGAL Interval_nt, MPFR's sine",
                                                               at_most<MpfrSine>, at_least<MpfrSine>};
const dumbbell_bench::Peer dumbbell_bench::cgal_with_own_sine{"CGAL Interval_nt, our sine", at_most<OwnSine>,
                                                              at_least<OwnSine>};
