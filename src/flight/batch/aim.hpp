#pragma once

#include "flight/batch/sine.hpp"

/// Where a ray (c, kappa) seems to meet the light wall, sin x = c + kappa x: what steers the bounds of
/// lower_step.hpp and upper_step.hpp, and proves nothing.
namespace dumbbell::flight::batch {

/// A point z of [0, half_pi_hi] to lay the tangent at. `at_top`: no contact is expected any more, and z is to
/// be where the ray comes closest, cos z = kappa.
template <class D>
struct Aim {
    D z;
    Mask<D> at_top;
};

namespace detail {

template <class D>
[[nodiscard]] D clamped(D z) {
    return min(max(z, D(0.0)), D(half_pi_hi));
}

/// acos(kappa), roughly.
template <class D>
[[nodiscard]] D rough_top(D kappa) {
    const D k = max(kappa, D(0.0));
    const D square = k * k;
    return clamped(half_pi_hi - k * (1.0 + square * (0.1667 + square * (0.065 + 0.31 * (square * square)))));
}

/// The next point after z, where sin z and cos z are `at`, on the way to a contact: a step of third order for
/// g(x) = sin x - kappa x - c.
template <class D>
[[nodiscard]] Aim<D> step_to_contact(D z, const SinCosOf<D>& at, D c, D kappa) {
    const D g = (at.sin - kappa * z) - c;
    const D slope = at.cos - kappa;
    const D inverse = 1.0 / slope;
    const D newton = -g * inverse;
    const D bend = 0.5 * at.sin * inverse;
    const D twist = at.cos * inverse * (1.0 / 6);
    const D t = bend * newton;  // the parabola through here has no root if it is above 1/4
    const D curved = newton * ((1.0 + t) + (t * t) * (2.0 + t * 5.0));
    const D next = (z + newton) + (curved * curved) * (bend + twist * curved);
    const auto lost = !(slope > D(0.0) && t <= D(0.25) && next <= D(half_pi_hi));
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

}  // namespace detail

/// The first point for a ray.
template <class D>
[[nodiscard]] Aim<D> first_aim(D c, D kappa) {
    const D inverse = 1.0 / (1.0 - kappa);
    const D t = c * inverse;  // x = t y with y = 1 + s y^3 + ...
    const D s = min(t * t * inverse * (1.0 / 6), D(0.15));
    const D z = detail::clamped(t * ((1.0 + s) + (s * s) * (3.0 + s * 12.0)));
    return detail::step_to_contact(z, rough_sin_cos(z), c, kappa);
}

/// The next point.
template <class D>
[[nodiscard]] Aim<D> next_aim(const Aim<D>& aim, const SinCosOf<D>& at, D c, D kappa) {
    const Aim<D> contact = detail::step_to_contact(aim.z, at, c, kappa);
    if (lanes(aim.at_top) == 0) {
        return contact;
    }
    const Aim<D> top = detail::step_to_top(aim.z, at, c, kappa);
    return {select(aim.at_top, top.z, contact.z), select(aim.at_top, top.at_top, contact.at_top)};
}

}  // namespace dumbbell::flight::batch
