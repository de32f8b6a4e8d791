#pragma once

#include "number/elementary.hpp"
#include "number/enclosure.hpp"

/// Two ways to write a quantity that depends on U over a box: plainly, as the Interval of its values, or as
/// a Slope, which also knows its value at U = 0 and what it changes by per unit of U. The rules of the law
/// are templates over both, X below.
namespace dumbbell::law {

/// Of x(U), U in the box: x(U) is in `range`, x(0) in `at0`, and (x(U) - x(0))/U in `slope`, U = 0 as the
/// limit.
struct Slope {
    Interval range;
    Interval at0;
    Interval slope;
};

/// The same quantity as X: the plain form keeps its values alone.
template <class X>
[[nodiscard]] X quantity(const Interval& range, const Interval& at0, const Interval& slope);
template <>
[[nodiscard]] inline Interval quantity<Interval>(const Interval& range, const Interval& /*at0*/,
                                                 const Interval& /*slope*/) {
    return range;
}
template <>
[[nodiscard]] inline Slope quantity<Slope>(const Interval& range, const Interval& at0,
                                           const Interval& slope) {
    return {range, at0, slope};
}

using dumbbell::range;  // of plain values
[[nodiscard]] inline const Interval& range(const Slope& x) { return x.range; }

// A whole number stands for itself, exactly.
[[nodiscard]] inline Interval operator+(int k, const Interval& x) { return Interval(k) + x; }
[[nodiscard]] inline Interval operator-(int k, const Interval& x) { return Interval(k) - x; }
[[nodiscard]] inline Interval operator*(int k, const Interval& x) { return Interval(k) * x; }
[[nodiscard]] inline Interval operator/(int k, const Interval& x) { return Interval(k) / x; }
[[nodiscard]] inline Interval operator/(const Interval& x, int k) { return x / Interval(k); }

[[nodiscard]] inline Slope operator+(const Slope& x, const Slope& y) {
    return {x.range + y.range, x.at0 + y.at0, x.slope + y.slope};
}
[[nodiscard]] inline Slope operator-(const Slope& x, const Slope& y) {
    return {x.range - y.range, x.at0 - y.at0, x.slope - y.slope};
}
[[nodiscard]] inline Slope operator-(const Slope& x) { return {-x.range, -x.at0, -x.slope}; }
[[nodiscard]] inline Slope operator*(const Slope& x, const Slope& y) {
    return {x.range * y.range, x.at0 * y.at0, x.at0 * y.slope + x.slope * y.range};
}
[[nodiscard]] inline Slope operator*(const Slope& x, const Interval& k) {
    return {x.range * k, x.at0 * k, x.slope * k};
}
[[nodiscard]] inline Slope operator*(const Interval& k, const Slope& x) { return x * k; }
[[nodiscard]] inline Slope operator*(int k, const Slope& x) { return x * Interval(k); }
[[nodiscard]] inline Slope operator/(const Slope& x, int k) { return {x.range / k, x.at0 / k, x.slope / k}; }
[[nodiscard]] inline Slope operator+(int k, const Slope& x) { return {k + x.range, k + x.at0, x.slope}; }
[[nodiscard]] inline Slope operator-(int k, const Slope& x) { return {k - x.range, k - x.at0, -x.slope}; }
[[nodiscard]] inline Slope operator-(const Slope& x, int k) {
    return {x.range - Interval(k), x.at0 - Interval(k), x.slope};
}
[[nodiscard]] inline Slope operator-(const Interval& k, const Slope& x) {
    return {k - x.range, k - x.at0, -x.slope};
}
[[nodiscard]] inline Slope operator/(int k, const Slope& x) {
    return {k / x.range, k / x.at0, k * -(x.slope / (x.at0 * x.range))};
}
[[nodiscard]] inline Slope operator/(const Slope& x, const Slope& y) { return x * (1 / y); }
[[nodiscard]] inline Slope sqr(const Slope& x) {
    return {sqr(x.range), sqr(x.at0), x.slope * (x.at0 + x.range)};
}
[[nodiscard]] inline Slope sqrt(const Slope& x) {
    const Interval of_range = sqrt(x.range), of_at0 = sqrt(x.at0);
    return {of_range, of_at0, x.slope / (of_range + of_at0)};
}

}  // namespace dumbbell::law
