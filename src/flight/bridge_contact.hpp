#pragma once

#include <algorithm>
#include <cmath>

#include "flight/chart.hpp"

/// Where rays that fly left from R meet the bridge: at psi = pi/2 - t, 0 < t < pi, where it has height r sin
/// t and slope r cos t.
namespace dumbbell::flight {

/// A flight to the left over the right corner: height there and slope; at t its height is height + kappa t.
template <class I>
struct BridgeApproach {
    I height;
    I kappa;
};

/// r sin t <= height + kappa t for all t in [0, pi], for all rays at or above these (thin) values: the bridge
/// lies below its tangent at some z, which is affine, so the two ends decide.
template <class I>
bool certainly_clears_bridge(const I& height, const I& kappa, const I& r) {
    if (certainly_at_most(r, kappa)) {
        return certainly_at_most(I(0), height);
    }
    const I z(std::acos(std::clamp(approximate(kappa) / approximate(r), -1.0, 1.0)));  // any z would do
    const SinCos<I> at = sin_cos(z);
    const I at_zero = height - r * (at.sin - z * at.cos);
    const I at_pi = height + kappa * pi<I>() - r * (at.sin + (pi<I>() - z) * at.cos);
    return certainly_at_most(I(0), at_zero) && certainly_at_most(I(0), at_pi);
}

/// The ray is below the bridge at t, 0 < t < pi: it and all lower ones, at all greater r, have met it before.
template <class I>
bool certainly_below_bridge(const BridgeApproach<I>& ray, const I& t, const I& r) {
    return certainly_less(t, pi<I>()) && certainly_less(ray.height + ray.kappa * t, r * sin_cos(t).sin);
}

/// Where the ray seems to dip below the bridge first: Newton's iteration on a convex function, from the left.
/// Of one that does not dip the guess is worth nothing.
inline double guess_bridge_contact(double height, double kappa, double r) {
    double t = 0;
    for (int i = 0; i < 40; ++i) {
        const double step = (height + kappa * t - r * std::sin(t)) / (r * std::cos(t) - kappa);
        if (!(step > 0)) {
            break;
        }
        t += step;
        if (step < 0x1p-40 * t) {
            break;
        }
    }
    return t;
}

/// An upper bound, at most pi, of the t of first contact, over all rays at or below `highest` with slope at
/// least `least_kappa`.
template <class I>
I latest_bridge_contact(const BridgeApproach<I>& highest, const I& least_kappa, const RatioRange<I>& range) {
    // A verifier that bounds the same contacts by its own means must not need more accuracy than this.
    constexpr double slack = 0x1p-26;
    I latest = high_end(pi<I>());
    // A contact needs kappa <= r cos t.
    const I cosine = min(least_kappa / range.r_lo, least_kappa / range.r_hi);
    for (const double pad : {slack, 0x1p-18}) {  // the second for slopes like r, where cos t is flat
        const I tangency(std::min(std::acos(std::clamp(approximate(cosine), -1.0, 1.0)) + pad, 3.2));
        if (certainly_less(tangency, pi<I>()) && certainly_at_most(sin_cos(tangency).cos, cosine)) {
            latest = tangency;
            break;
        }
    }
    // A little beyond the place where the highest ray seems to dip below the bridge.
    const double r = approximate(range.r_lo);
    const double height = approximate(highest.height);
    const double kappa = approximate(highest.kappa);
    const double parallel = std::acos(std::clamp(kappa / r, -1.0, 1.0));
    if (height + kappa * parallel < r * std::sin(parallel)) {
        const I dip(guess_bridge_contact(height, kappa, r) * (1 + slack) + 0x1p-40);
        if (certainly_less(dip, latest) && certainly_below_bridge(highest, dip, range.r_lo)) {
            latest = dip;
        }
    }
    return latest;
}

/// The bridge's tangent at t, to the left, in units of r: after a contact at most at t, a ray to the left
/// lies above it (L6).
template <class I>
ScaledRay<I> bridge_tangent(const I& t) {
    const SinCos<I> at = sin_cos(t);
    return {max(I(0), at.sin + at.cos * (pi<I>() - t)), at.cos};
}

}  // namespace dumbbell::flight
