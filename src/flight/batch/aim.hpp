#pragma once

#include "flight/batch/sine.hpp"
#include "flight/way_to_contact.hpp"

/// Where a ray (c, kappa) seems to meet the light wall, sin x = c + kappa x: what steers the bounds of
/// lower_bounce.hpp and upper_bounce.hpp, and proves nothing.
namespace dumbbell::flight::batch {

template <class D>
[[nodiscard]] D clamped(D z) {
    return min(max(z, D(0.0)), D(half_pi_hi));
}

/// A first point for a ray of which nothing else is known.
template <class D>
[[nodiscard]] D first_point(D c, D kappa) {
    const D inverse = 1.0 / (1.0 - kappa);
    const D t = c * inverse;
    const D s = min(t * t * inverse * (1.0 / 6), D(0.15));
    const D v = s * (t * t) * 0.05;
    // x = t y with y = 1 + s y^3 - v y^5 + ...
    const D y = (1.0 + s) + (s * s) * ((3.0 + s * 12.0) + (s * s) * 55.0);
    return clamped(t * (y - v * (1.0 + s * (8.0 + s * 50.0))));
}

/// acos(kappa), roughly: where a ray that passes above the wall comes closest to it.
template <class D>
[[nodiscard]] D rough_top(D kappa) {
    const D k = max(kappa, D(0.0));
    const D square = k * k;
    return clamped(half_pi_hi - k * (1.0 + square * (0.1667 + square * (0.065 + 0.31 * (square * square)))));
}

/// A point z of [0, half_pi_hi] to look for the contact at. `at_top`: none is expected any more, and z is to
/// be where the ray comes closest, cos z = kappa.
template <class D>
struct Aim {
    D z;
    Mask<D> at_top;
};

/// The next point after a contact at x, for the ray of slope kappa that leaves it: a step from there, whose
/// wall is kappa (2 x + pi) below the ray. `inverse` is 1/slope for the ray that came. `at_top` here: that
/// step does not lead to a contact.
template <class D>
[[nodiscard]] Aim<D> point_after(D x, const SinCosOf<D>& at, D kappa, D inverse) {
    const D slope = at.cos - kappa;
    const D now = inverse * (2.0 - slope * inverse);  // about 1/slope
    const D newton = (kappa * ((x + x) + 2 * half_pi_hi)) * now;
    const D z = x + way_to_contact(newton, now, at);
    return {z, !(slope > D(0.0) && z <= D(half_pi_hi))};
}

/// The point after z, where sin z and cos z are `at`, if a step leads to `next`.
template <class D>
[[nodiscard]] Aim<D> step_to_contact(D next, const SinCosOf<D>& at, D kappa) {
    const auto lost = !(at.cos > kappa && next <= D(half_pi_hi));
    return {select(lost, rough_top(kappa), clamped(next)), lost};
}

/// The same on the way to the top. From the top itself, if it is above the ray: back to the contact.
template <class D>
[[nodiscard]] Aim<D> step_to_top(D z, const SinCosOf<D>& at, D c, D kappa) {
    const D g = (at.sin - kappa * z) - c;
    const D slope = at.cos - kappa;
    const auto there = abs(slope) < D(0x1p-12) || (z >= D(half_pi_hi) && slope >= D(0.0));
    const auto above = there && g > D(0.0);
    const D back = z - sqrt(max(2.0 * g, D(0.0)) / at.sin);
    return {clamped(select(above, back, z + slope / at.sin)), !above};
}

}  // namespace dumbbell::flight::batch
