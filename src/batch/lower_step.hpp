#pragma once

#include "batch/aim.hpp"

/// One collision of the lowest, flattest ray of a set, followed with lower bounds (L5 (e), L12).
///
/// Every pad is that of L39: the sum of the sizes of all terms, times 16 u. Rounding takes less than half of
/// it; the rest is what lets quotients and heights go without a pad of their own. Precondition: z in [0,
/// half_pi_hi] with its sine and cosine, c >= 0, -1 <= kappa < 1, 0 < r <= 1.
namespace dumbbell::batch {

inline constexpr double relative_pad = 0x1p-49;
inline constexpr double least_pad = 0x1p-1000;
inline constexpr double pi_below = 2 * half_pi_hi;
inline constexpr double half_pi_above = 0x1.921fb54442d19p+0;

template <class D>
[[nodiscard]] D padding(D size) {
    return size * relative_pad + least_pad;
}

/// A bound of the contact from the tangent at z (L12 (a)): x >= z + shift >= 0 for every ray that collides.
template <class D>
struct LowerContact {
    D shift;
    Mask<D> close;   ///< it is certain, and as close as doubles allow
    Mask<D> beyond;  ///< it lies beyond the peak: certainly none collides
};

template <class D>
[[nodiscard]] LowerContact<D> lower_contact(D z, const SinCosOf<D>& at, D c, D kappa) {
    const D line = kappa * z;
    const D g = ((at.sin - line) - c) + padding(at.sin + abs(line) + c);  // from above
    const D slope = at.cos - kappa;
    const D slope_pad = padding(at.cos + abs(kappa));
    const D least_slope = slope - slope_pad;
    const D newton = g / select(g >= D(0.0), least_slope, slope + slope_pad);
    const D shift = max(-newton, -z);
    const Mask<D> certain = least_slope > D(0.0);
    return {shift, certain && abs(shift) <= D(0x1p-25), certain && z + shift > D(half_pi_above)};
}

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

/// The state after the collision, if `leaves` is not set and `follows` is.
template <class D>
struct LowerState {
    D c;
    D kappa;
    Mask<D> leaves;   ///< certainly D <= 0
    Mask<D> follows;  ///< the numerator of the slope is certainly positive
    Mask<D> clear;    ///< nothing was decided by less than a thousandth: wider bounds would say the same
};

template <class D>
[[nodiscard]] LowerState<D> lower_state(D z, const SinCosOf<D>& at, D shift, D kappa, D r) {
    // sin(z + d) >= sin z + d cos z - d^2/2 (z + |d|), and cos(z + d) lies below its tangent.
    const D rise = at.cos * shift;
    const D bend = 0.5 * (shift * shift) * (z + abs(shift));
    const D sine = (at.sin + rise) - (bend + padding(at.sin + abs(rise) + bend));
    const D fall = at.sin * shift;
    const D w = (at.cos - fall) + padding(at.cos + abs(fall));

    const D product = w * (w - 2.0 * kappa);
    const D denominator = (product - r) + padding(abs(product) + r);
    const D first = (kappa * w) * w;
    const D second = r * (2.0 * w - kappa);
    const D numerator = (first + second) - padding(abs(first) + abs(second));
    const D next = numerator / denominator;
    const D height = max(sine, D(0.0)) + next * ((z + shift) + pi_below);
    return {height, next, denominator <= D(0.0), numerator > D(0.0),
            at.cos - kappa > D(0x1p-10) && denominator > product * 0x1p-10};
}

}  // namespace dumbbell::batch
