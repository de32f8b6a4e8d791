#pragma once

#include <cmath>
#include <limits>

#include "number/ends.hpp"
#include "number/rounding.hpp"

namespace dumbbell {

/// A closed interval of doubles, lo <= hi, that encloses a real number or a set of them.
///
/// For all x in X, y in Y, x op y is in X op Y: each end is an exact end's nearest double, moved to the
/// neighbour (ends::above). What has an infinite or no answer is left to Boost.Interval, with
/// NeighbourRounding (interval.cpp). Division by an interval that contains 0 gives the whole line, or what is
/// on one side. Empty or NaN operands give intervals whose comparisons are all false: of an end that is NaN
/// nothing is known, and the other end is right by itself. Nothing converts implicitly; decimals go through
/// Rational and enclose().
class Interval {
  public:
    Interval() : Interval(0.0) {}
    explicit Interval(double point) : ends_{-point, point} {}
    /// NaN unless lo <= hi.
    Interval(double lo, double hi) : ends_(lo <= hi ? ends::Pair{-lo, hi} : ends::twice(nan)) {}

    [[nodiscard]] double lo() const noexcept { return -ends_[0]; }
    [[nodiscard]] double hi() const noexcept { return ends_[1]; }
    [[nodiscard]] bool is_nan() const noexcept { return !(lo() <= hi()); }

    friend Interval operator+(const Interval& a, const Interval& b) {
        return Interval(ends::above(a.ends_ + b.ends_));
    }
    friend Interval operator-(const Interval& a, const Interval& b) {
        return Interval(ends::above(a.ends_ + ends::swapped(b.ends_)));
    }
    friend Interval operator-(const Interval& a) { return Interval(ends::swapped(a.ends_)); }

    /// The ends are the least and the greatest of four products, and rounding does not change their order
    /// (L62).
    friend Interval operator*(const Interval& a, const Interval& b) {
        if (ends::max(a.ends_, b.ends_)[0] < 0) [[likely]] {  // both are positive
            return Interval(ends::above(ends::Pair{-a.ends_[0], a.ends_[1]} * b.ends_));
        }
        const ends::Pair p = ends::twice(a.ends_[0]) * b.ends_;
        const ends::Pair q = ends::twice(a.ends_[1]) * b.ends_;
        const ends::Pair sum = p + q;
        if (std::isnan(sum[0] + sum[1])) [[unlikely]] {
            return hard_product(a, b);
        }
        const Interval nearest(ends::max(ends::max(ends::swapped(p), q), -ends::min(p, ends::swapped(q))));
        if (nearest.lo() == 0 && nearest.hi() == 0) [[unlikely]] {
            return hard_product(a, b);  // 0 if a factor is
        }
        return Interval(ends::above(nearest.ends_ + ends::twice(0)));  // +0, if one of the greatest is
    }
    friend Interval operator/(const Interval& a, const Interval& b) {
        if (b.lo() > 0) [[likely]] {
            return Interval(quotient(a.ends_, b.ends_));
        }
        return b.hi() < 0 ? Interval(quotient(ends::swapped(a.ends_), ends::swapped(b.ends_)))
                          : hard_quotient(a, b);
    }

    /// With the double beyond each end; an end 0 may stay.
    friend Interval with_neighbours(const Interval& a) { return Interval(ends::above(a.ends_)); }

    friend Interval sqr(const Interval& a) {
        const ends::Pair other = ends::swapped(a.ends_);
        const ends::Pair least = ends::min(ends::twice(0), ends::min(a.ends_, other));  // sizes, less than 0
        const ends::Pair greatest = ends::max(a.ends_, other);
        return Interval(ends::above(ends::Pair{least[0], greatest[1]} * ends::Pair{-least[0], greatest[1]}));
    }
    /// Of the part of `a` that is >= 0. Precondition: hi >= 0.
    friend Interval sqrt(const Interval& a);
    friend Interval abs(const Interval& a);

    /// NaN if either is.
    friend Interval hull(const Interval& a, const Interval& b) {
        return a.is_nan() || b.is_nan() ? Interval(nan) : Interval(ends::max(a.ends_, b.ends_));
    }
    friend Interval min(const Interval& a, const Interval& b) { return -max(-a, -b); }
    friend Interval max(const Interval& a, const Interval& b) {
        return a.is_nan() || b.is_nan()
                   ? Interval(nan)
                   : Interval(ends::Pair{ends::min(a.ends_, b.ends_)[0], ends::max(a.ends_, b.ends_)[1]});
    }

  private:
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    explicit Interval(ends::Pair bounds) : ends_(bounds) {}

    /// For b > 0: an end that is not below 0 is divided by the least of b, any other by the greatest (L62).
    static ends::Pair quotient(ends::Pair a, ends::Pair b) {
        return ends::above(a / (a >= 0 ? ends::twice(-b[0]) : ends::twice(b[1])));
    }
    /// Where an end is infinite or NaN, or a sum of products is, or all products round to 0.
    static Interval hard_product(Interval a, Interval b);
    /// Where b contains 0, or is NaN.
    static Interval hard_quotient(Interval a, Interval b);

    ends::Pair ends_;  ///< both NaN, or in order, or the other one infinite where one is NaN
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
