#pragma once

#include "number/elementary.hpp"
#include "number/enclosure.hpp"

/// A quantity that depends on U over a box, with what it does near U = 0: the rules of the law divide by U
/// and by U^2.
namespace dumbbell::law {

/// Of x(U), U in the box: x(U) is in `range`, x(0) in `at0`, x'(0) in `first`, (x(U) - x(0))/U in `slope` and
/// (x(U) - x(0) - x'(0) U)/U^2 in `second`, U = 0 as the limit.
struct Slope {
    Interval range;
    Interval at0, first;
    Interval slope, second;
};

/// x0 + x1 U.
[[nodiscard]] inline Slope line(const Interval& U, const Interval& x0, const Interval& x1) {
    return {x0 + U * x1, x0, x1, x1, Interval(0)};
}
/// A number that does not depend on U.
[[nodiscard]] inline Slope constant(const Interval& x) {
    return {x, x, Interval(0), Interval(0), Interval(0)};
}
/// 1 + x2 U^2, whose values lie in `range` as well.
[[nodiscard]] inline Slope one_and(const Interval& U, const Interval& x2, const Interval& range) {
    return {range, Interval(1), Interval(0), U * x2, x2};
}
/// x2 U^2.
[[nodiscard]] inline Slope squared(const Interval& U, const Interval& x2) {
    return {sqr(U) * x2, Interval(0), Interval(0), U * x2, x2};
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
    return {x.range + y.range, x.at0 + y.at0, x.first + y.first, x.slope + y.slope, x.second + y.second};
}
[[nodiscard]] inline Slope operator-(const Slope& x) {
    return {-x.range, -x.at0, -x.first, -x.slope, -x.second};
}
[[nodiscard]] inline Slope operator-(const Slope& x, const Slope& y) { return x + -y; }
[[nodiscard]] inline Slope operator*(const Slope& x, const Slope& y) {
    return {x.range * y.range, x.at0 * y.at0, x.at0 * y.first + x.first * y.at0,
            x.at0 * y.slope + x.slope * y.range, x.at0 * y.second + x.first * y.slope + x.second * y.range};
}
[[nodiscard]] inline Slope operator*(const Slope& x, const Interval& k) {
    return {x.range * k, x.at0 * k, x.first * k, x.slope * k, x.second * k};
}
[[nodiscard]] inline Slope operator*(const Interval& k, const Slope& x) { return x * k; }
[[nodiscard]] inline Slope operator*(int k, const Slope& x) { return x * Interval(k); }
[[nodiscard]] inline Slope operator/(const Slope& x, int k) {
    return {x.range / k, x.at0 / k, x.first / k, x.slope / k, x.second / k};
}
[[nodiscard]] inline Slope operator/(const Slope& x, const Interval& k) { return x * (Interval(1) / k); }
[[nodiscard]] inline Slope operator+(const Slope& x, const Interval& k) {
    return {x.range + k, x.at0 + k, x.first, x.slope, x.second};
}
[[nodiscard]] inline Slope operator-(const Interval& k, const Slope& x) { return -x + k; }
[[nodiscard]] inline Slope operator+(int k, const Slope& x) { return x + Interval(k); }
[[nodiscard]] inline Slope operator-(int k, const Slope& x) { return -x + Interval(k); }
[[nodiscard]] inline Slope operator-(const Slope& x, int k) { return x + Interval(-k); }
[[nodiscard]] inline Slope operator/(int k, const Slope& x) {
    const Interval both = x.at0 * x.range;
    return {k / x.range, k / x.at0, k * -(x.first / sqr(x.at0)), k * -(x.slope / both),
            k * ((x.first * (x.slope / x.at0) - x.second) / both)};
}
[[nodiscard]] inline Slope operator/(const Slope& x, const Slope& y) { return x * (1 / y); }
[[nodiscard]] inline Slope sqr(const Slope& x) {
    return {sqr(x.range), sqr(x.at0), 2 * (x.at0 * x.first), x.slope * (x.at0 + x.range),
            x.first * x.slope + x.second * (x.at0 + x.range)};
}
[[nodiscard]] inline Slope sqrt(const Slope& x) {
    const Interval of_range = sqrt(x.range), of_at0 = sqrt(x.at0), sum = of_range + of_at0;
    const Interval slope = x.slope / sum, first = x.first / (2 * of_at0);
    return {of_range, of_at0, first, slope, (x.second - first * slope) / sum};
}

}  // namespace dumbbell::law
