#include "collisions/coordinate.hpp"

#include <limits>

namespace dumbbell::collisions {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Coordinate::Coordinate(const Rational& value)
    : double_(value.convert_to<double>()),
      rational_(std::make_shared<const Kept>(
          Kept{value, enclose<Interval>(value),
               value > 0 ? enclose<Interval>(Rational(1) / value) : Interval(-infinity, infinity)})) {}

Coordinate::operator Rational() const { return rational_ ? rational_->value : exact(double_); }

template <>
Interval Coordinate::enclosure() const {
    return rational_ ? rational_->enclosure : Interval(double_);
}
template <>
BigInterval Coordinate::enclosure() const {
    return enclose<BigInterval>(*this);
}
template <>
Interval Coordinate::inverse() const {
    return rational_ ? rational_->inverse : enclose<Interval>(Rational(1) / Rational(*this));
}
template <>
BigInterval Coordinate::inverse() const {
    return enclose<BigInterval>(Rational(1) / Rational(*this));
}

Coordinate middle(const Coordinate& a, const Coordinate& b) {
    if (!a.rational_ && !b.rational_) {
        // TwoSum: the rounding error of the sum, exactly (unless the sum is infinite). A half is exact down
        // to 2^-1021.
        const double sum = a.double_ + b.double_;
        const double part = sum - a.double_;
        const double error = (a.double_ - (sum - part)) + (b.double_ - part);
        if (error == 0 && sum >= 0x1p-1000) {
            return sum / 2;
        }
    }
    return Coordinate((Rational(a) + Rational(b)) / 2);
}

double width(const Coordinate& lo, const Coordinate& hi) {
    return lo.rational_ || hi.rational_ ? (Rational(hi) - Rational(lo)).convert_to<double>()
                                        : hi.double_ - lo.double_;
}

}  // namespace dumbbell::collisions
