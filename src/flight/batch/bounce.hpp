#pragma once

#include "flight/batch/place.hpp"

/// What lower_bounce.hpp and upper_bounce.hpp share: one collision of a ray that is followed with bounds (L5
/// (e)), from the sine and cosine of one point z of [0, half_pi_hi] near the contact.
///
/// Every pad is that of L39: sizes times 16 u. Rounding takes at most two thirds of it; the rest is what lets
/// quotients and heights go without a pad of their own. Precondition everywhere: c >= 0, -1 <= kappa < 1, and
/// r is a double of [2^-900, 1] times `outward` of the bound.
namespace dumbbell::flight::batch {

inline constexpr double relative_pad = 0x1p-49;
inline constexpr double least_pad = 0x1p-1000;
inline constexpr double half_pi_above = 0x1.921fb54442d19p+0;  // RU(pi/2)

template <class D>
[[nodiscard]] D padding(D size) {
    return size * relative_pad + least_pad;
}

/// The bound z + shift >= 0 of the contact.
template <class D>
struct Contact {
    D shift;
    Mask<D> close;  ///< it is certain, and as close as doubles allow
};

/// So small that no more than the first terms of Taylor's formula for sine and cosine are needed.
template <class D>
[[nodiscard]] Mask<D> small(D shift, const Place<D>& place) {
    return abs(shift) <= min(place.least, D(0x1p-25)) + 0x1p-960;
}

/// What follows the contact. Precondition: it is certain.
template <class D>
struct Bounce {
    D c;
    D kappa;
    SinCosOf<D> at;   ///< the bounds of sine and cosine at the contact
    Mask<D> ends;     ///< there is no later collision, or none that is certain
    Mask<D> follows;  ///< c and kappa bound the next state
    Mask<D> clear;    ///< nothing was decided by less than a thousandth: other bounds would say the same
};

/// L12 (c): certainly g < 0 on [0, pi/2].
template <class D>
[[nodiscard]] Mask<D> strict_miss(D z, const SinCosOf<D>& at, D c, D kappa) {
    const D fall = z * at.cos;
    const D rise = (half_pi_hi - z) * at.cos;
    const D line = kappa * half_pi_hi;
    const D size = c + at.sin;
    return ((c - at.sin) + fall) - padding(size + fall) > D(0.0) &&
           (((c + line) - at.sin) - rise) - padding(size + abs(line) + rise) > D(0.0);
}

}  // namespace dumbbell::flight::batch
