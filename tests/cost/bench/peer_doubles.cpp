#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <boost/numeric/interval.hpp>
#include <type_traits>

#include "peers.hpp"

namespace dumbbell_bench {
namespace {

using Cgal = CGAL::Interval_nt<false>;           // its user keeps the rounding mode upward
using Boost = boost::numeric::interval<double>;  // default policies: each operation switches it
using Upward = CGAL::Protect_FPU_rounding<true>;

double low(const Cgal& x) { return x.inf(); }
double high(const Cgal& x) { return x.sup(); }
double low(const Boost& x) { return x.lower(); }
double high(const Boost& x) { return x.upper(); }
Cgal square_of(const Cgal& x) { return CGAL::square(x); }
Boost square_of(const Boost& x) { return boost::numeric::square(x); }

template <class V>
class Wrapped {
  public:
    Wrapped() = default;
    explicit Wrapped(double point) : value_(point) {}
    Wrapped(double lo, double hi) : value_(lo, hi) {}
    explicit Wrapped(const dumbbell::Interval& x) : value_(x.lo(), x.hi()) {}

    [[nodiscard]] double lo() const { return low(value_); }
    [[nodiscard]] double hi() const { return high(value_); }

    friend Wrapped operator+(const Wrapped& a, const Wrapped& b) { return Wrapped(a.value_ + b.value_); }
    friend Wrapped operator-(const Wrapped& a, const Wrapped& b) { return Wrapped(a.value_ - b.value_); }
    friend Wrapped operator*(const Wrapped& a, const Wrapped& b) { return Wrapped(a.value_ * b.value_); }
    friend Wrapped operator/(const Wrapped& a, const Wrapped& b) { return Wrapped(a.value_ / b.value_); }
    friend Wrapped operator-(const Wrapped& a) { return Wrapped(-a.value_); }
    friend Wrapped sqr(const Wrapped& a) { return Wrapped(square_of(a.value_)); }
    friend Wrapped max(const Wrapped& a, const Wrapped& b) {
        return {std::max(a.lo(), b.lo()), std::max(a.hi(), b.hi())};
    }
    friend Wrapped hull(const Wrapped& a, const Wrapped& b) {
        return {std::min(a.lo(), b.lo()), std::max(a.hi(), b.hi())};
    }
    friend Wrapped low_end(const Wrapped& a) { return Wrapped(a.lo()); }
    friend Wrapped high_end(const Wrapped& a) { return Wrapped(a.hi()); }
    friend bool certainly_less(const Wrapped& a, const Wrapped& b) { return a.hi() < b.lo(); }
    friend bool certainly_at_most(const Wrapped& a, const Wrapped& b) { return a.hi() <= b.lo(); }
    friend bool certainly_positive(const Wrapped& a) { return a.lo() > 0; }
    friend double approximate(const Wrapped& a) { return a.lo(); }
    friend dumbbell::flight::ContactGuess<Wrapped> guess_contact(const Wrapped& c, const Wrapped& kappa,
                                                                 double start) {
        return guess_for(c, kappa, start);
    }
    /// Of a point: the rays ask for no other. This project's wants another rounding mode than CGAL.
    friend dumbbell::SinCos<Wrapped> sin_cos(const Wrapped& a) {
        constexpr bool upward = std::is_same_v<V, Cgal>;
        if (upward) {
            CGAL::FPU_set_cw(CGAL_FE_TONEAREST);
        }
        const auto both = dumbbell::sin_cos(dumbbell::Interval(a.lo()));
        if (upward) {
            CGAL::FPU_set_cw(CGAL_FE_UPWARD);
        }
        return {Wrapped(both.sin), Wrapped(both.cos)};
    }

  private:
    explicit Wrapped(const V& value) : value_(value) {}

    V value_;
};

using OfCgal = Wrapped<Cgal>;
using OfBoost = Wrapped<Boost>;

}  // namespace
}  // namespace dumbbell_bench

using namespace dumbbell_bench;

template <>
OfCgal dumbbell::pi() {
    return OfCgal(pi<Interval>());
}
template <>
OfBoost dumbbell::pi() {
    return OfBoost(pi<Interval>());
}
template <>
OfCgal dumbbell::half_pi() {
    return OfCgal(half_pi<Interval>());
}
template <>
OfBoost dumbbell::half_pi() {
    return OfBoost(half_pi<Interval>());
}
template <>
OfCgal dumbbell::flight::detail::least_step() {
    return OfCgal(0x1p-1000);
}
template <>
OfBoost dumbbell::flight::detail::least_step() {
    return OfBoost(0x1p-1000);
}

std::vector<Arithmetic> dumbbell_bench::cgal_and_boost() {
    return {arithmetic<OfCgal, Upward>("CGAL"), arithmetic<OfBoost, NoScope>("Boost")};
}
