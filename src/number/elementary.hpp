#pragma once

#include "number/interval.hpp"

/// Elementary functions on Interval, defined for every interval that is not empty. glibc's are not used: they
/// ignore rounding and promise no error bound.
///
/// - sin_cos, sin, cos: enclosures; [-1, 1] where an argument exceeds 2^20 in absolute value.
/// - asin: an enclosure for the part of the argument that lies in [-1, 1].
/// - pi, half_pi: two neighbouring doubles.
namespace dumbbell {

/// Enclosures of sine and cosine of the same argument.
template <class I>
struct SinCos {
    I sin;
    I cos;
};

/// sin and cos of one double in [0, pi/2] without an error bound: for guesses (Newton iterates) only.
struct SinCosGuess {
    double sin;
    double cos;
};
[[nodiscard]] SinCosGuess guess_sin_cos(double x) noexcept;

/// Enclosures of sine and cosine at the double z + shift, from guess_sin_cos(z). Preconditions: 2^-900 <= z
/// <= pi/2, and |shift| is at most 2^-13 and 2^-8 times both (L63 (b)).
[[nodiscard]] SinCos<Interval> sin_cos_beside(const SinCosGuess& at, double shift) noexcept;

[[nodiscard]] SinCos<Interval> sin_cos(const Interval& x);
[[nodiscard]] Interval sin(const Interval& x);
[[nodiscard]] Interval cos(const Interval& x);
[[nodiscard]] Interval asin(const Interval& x);

/// pi lies between these neighbouring doubles: sin(0x1.921fb54442d18p+1) = 1.22e-16 > 0 > sin of the next
/// one; checked against MPFR in the tests.
template <class I>
[[nodiscard]] I pi();
template <>
[[nodiscard]] inline Interval pi<Interval>() {
    return {0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};
}

/// pi/2, exactly half of pi().
template <class I>
[[nodiscard]] I half_pi();
template <>
[[nodiscard]] inline Interval half_pi<Interval>() {
    return {0x1.921fb54442d18p+0, 0x1.921fb54442d19p+0};
}

}  // namespace dumbbell
