#pragma once

#include <type_traits>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// Bounds of N of all bodies of a rectangle at once, from orbits that leave a wall of the valley at a right
/// angle (plane.md, L86, L87).
namespace dumbbell::collisions {

/// All bodies with rho in one range, and Q in another.
struct Rectangle {
    Range rho, q;
};

/// At least `bound` collisions of every body of a rectangle, by the orbit (j, p); j = 0: by what needs none.
struct LowerBound {
    long bound = 0, j = 0;
    Rational p = 0;
};

/// So many bits tell numbers of this type apart.
template <class I>
[[nodiscard]] int bits_of() {
    return std::is_same_v<I, Interval> ? double_bits : PrecisionScope::current();
}

/// The greatest that is found, with the rectangle as a whole.
template <class I = Interval>
[[nodiscard]] LowerBound least_collisions(const Rectangle& bodies, const Interrupted& interrupted = never);
/// Nothing if it is not certain that no body of the rectangle has more than `upper`.
template <class I = Interval>
[[nodiscard]] std::optional<UpperBound> at_most(long upper, const Rectangle& bodies,
                                                const Interrupted& interrupted = never);
/// About the place e_j of the bridge that the orbit with the middle collision j touches (L81 of body.md); the
/// top for j = 0.
template <class I>
[[nodiscard]] Rational touching_place(long j, const Rational& rho, const Rational& q);

}  // namespace dumbbell::collisions
