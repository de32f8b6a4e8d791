#pragma once

#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <cmath>
#include <limits>

#include "number/rounding.hpp"

namespace dumbbell {

/// A closed interval of doubles, lo <= hi, that encloses a real number or a set of them.
///
/// Arithmetic is Boost.Interval's with NeighbourRounding: for all x in X, y in Y, x op y is in X op Y.
/// Division by an interval that contains 0 gives the whole line. Empty or NaN operands give intervals whose
/// comparisons are all false. Nothing converts implicitly; decimals go through Rational and enclose().
class Interval {
  public:
    Interval() = default;
    explicit Interval(double point) : value_(point) {}
    Interval(double lo, double hi) : value_(lo, hi) {}

    [[nodiscard]] double lo() const noexcept { return value_.lower(); }
    [[nodiscard]] double hi() const noexcept { return value_.upper(); }
    [[nodiscard]] bool is_nan() const noexcept { return !(lo() <= hi()); }

    friend Interval operator+(const Interval& a, const Interval& b) { return Interval(a.value_ + b.value_); }
    friend Interval operator-(const Interval& a, const Interval& b) { return Interval(a.value_ - b.value_); }
    friend Interval operator*(const Interval& a, const Interval& b) { return Interval(a.value_ * b.value_); }
    friend Interval operator/(const Interval& a, const Interval& b) { return Interval(a.value_ / b.value_); }
    friend Interval operator-(const Interval& a) { return Interval(-a.value_); }

    friend Interval sqr(const Interval& a) { return Interval(boost::numeric::square(a.value_)); }
    /// Of the part of `a` that is >= 0. Precondition: hi >= 0.
    friend Interval sqrt(const Interval& a) { return Interval(boost::numeric::sqrt(a.value_)); }
    friend Interval abs(const Interval& a) { return Interval(boost::numeric::abs(a.value_)); }
    /// NaN if either is: Boost would take it for the empty set and return the other.
    friend Interval hull(const Interval& a, const Interval& b) {
        return a.is_nan() || b.is_nan() ? Interval(std::numeric_limits<double>::quiet_NaN())
                                        : Interval(boost::numeric::hull(a.value_, b.value_));
    }
    friend Interval min(const Interval& a, const Interval& b) {
        return Interval(boost::numeric::min(a.value_, b.value_));
    }
    friend Interval max(const Interval& a, const Interval& b) {
        return Interval(boost::numeric::max(a.value_, b.value_));
    }

  private:
    using Policies =
        boost::numeric::interval_lib::policies<NeighbourRounding,
                                               boost::numeric::interval_lib::checking_base<double>>;
    using Value = boost::numeric::interval<double, Policies>;

    explicit Interval(const Value& value) : value_(value) {}

    Value value_;
};

/// The ends of X as thin intervals: the vocabulary in which monotone bounds are written.
[[nodiscard]] inline Interval low_end(const Interval& x) { return Interval(x.lo()); }
[[nodiscard]] inline Interval high_end(const Interval& x) { return Interval(x.hi()); }

/// True only if every x in X is less (at most) than every y in Y. False for NaN.
[[nodiscard]] inline bool certainly_less(const Interval& x, const Interval& y) { return x.hi() < y.lo(); }
[[nodiscard]] inline bool certainly_at_most(const Interval& x, const Interval& y) { return x.hi() <= y.lo(); }
[[nodiscard]] inline bool certainly_positive(const Interval& x) { return x.lo() > 0; }

/// Some double in the middle of X: for guesses only, no claim may rest on it.
[[nodiscard]] inline double approximate(const Interval& x) { return x.lo() + (x.hi() - x.lo()) / 2; }
/// A thin interval near the middle of X: for guesses only.
[[nodiscard]] inline Interval midpoint(const Interval& x) { return Interval(approximate(x)); }
/// Upper bound of hi - lo.
[[nodiscard]] inline double width(const Interval& x) { return next_up(x.hi() - x.lo()); }

}  // namespace dumbbell
