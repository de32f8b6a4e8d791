#pragma once

#include <memory>

#include "number/rational.hpp"

namespace dumbbell::collisions {

/// An end of a box's side, exact: a double, or a rational with what is asked of it over and over, which
/// copies share. Boxes are halved by the million, and halves of doubles are doubles as long as 53 bits hold
/// them.
class Coordinate {
  public:
    Coordinate(double value) : double_(value) {}  // NOLINT(google-explicit-constructor): no value is lost
    Coordinate(const Rational& value);            // NOLINT(google-explicit-constructor)
    operator Rational() const;                    // NOLINT(google-explicit-constructor)

    /// The tightest enclosures of x in I, and of 1/x. Precondition: x > 0 for the latter.
    template <class I>
    [[nodiscard]] I enclosure() const;
    template <class I>
    [[nodiscard]] I inverse() const;

    /// (a + b) / 2, exactly.
    friend Coordinate middle(const Coordinate& a, const Coordinate& b);
    /// hi - lo, rounded: for choices only, no claim may rest on it.
    friend double width(const Coordinate& lo, const Coordinate& hi);
    /// The nearest double: likewise.
    friend double approximate(const Coordinate& x) { return x.double_; }

  private:
    struct Kept {
        Rational value;
        Interval enclosure, inverse;
    };

    double double_;
    std::shared_ptr<const Kept> rational_;  ///< nothing: the value is the double
};

template <>
[[nodiscard]] Interval Coordinate::enclosure() const;
template <>
[[nodiscard]] BigInterval Coordinate::enclosure() const;
template <>
[[nodiscard]] Interval Coordinate::inverse() const;
template <>
[[nodiscard]] BigInterval Coordinate::inverse() const;

}  // namespace dumbbell::collisions
