#pragma once

#include "flight/ray.hpp"
#include "flight/reflection.hpp"
#include "number/elementary.hpp"

/// The two charts of the turning section and the rays that leave their states (lemmas L8, L9, L10;
/// format.md, sections 3.3-3.5).
namespace dumbbell::flight {

/// A position on a wall by its corner distance e in [0, pi/2] (0: the corner, pi/2: the peak), with sin e and
/// cos e.
template <class I>
struct Position {
    I e;
    I sin_e;
    I cos_e;
};

/// The position at min(e, pi/2).
template <class I>
Position<I> position(const I& e) {
    const I clipped = min(e, half_pi<I>());
    const SinCos<I> at = sin_cos(clipped);
    return {clipped, max(I(0), at.sin), max(I(0), at.cos)};
}

/// The mass ratios 1/r of a box: enclosures of the least and the greatest r.
template <class I>
struct RatioRange {
    I r_lo;
    I r_hi;
};

/// A ray in units of r: height c = r * `c`, slope kappa = r * `lambda`.
template <class I>
struct ScaledRay {
    I c;
    I lambda;
};

template <class I>
Ray<I> at_ratio(const ScaledRay<I>& ray, const I& r) {
    return {r * ray.c, r * ray.lambda, r};
}

/// Chart bridge: the outgoing ray X of the contact at corner distance e, with slope eta above the bridge's
/// tangent (units of r).
template <class I>
ScaledRay<I> bridge_outgoing(const Position<I>& at, const I& eta) {
    const I lambda = at.cos_e + eta;
    return {at.sin_e + lambda * (pi<I>() - at.e), lambda};
}

/// Chart bridge: the reversed incoming ray sigma X, at mass ratio 1/r. Its height is never negative (L6).
template <class I>
ScaledRay<I> bridge_reversed(const Position<I>& at, const I& eta, const I& r) {
    const I lambda = reversed_steepness(eta, at.cos_e, r) - at.cos_e;
    return {max(I(0), at.sin_e + lambda * at.e), lambda};
}

/// Chart light: the ray that leaves R at corner distance e to the left with slope `kappa`.
template <class I>
Ray<I> light_outgoing(const Position<I>& at, const I& kappa, const I& r) {
    return {at.sin_e + kappa * (pi<I>() + at.e), kappa, r};
}

/// A single ray that lies below r -> at_ratio(ray, r) for every r of the range, as far as the count G is
/// concerned: the ray's lower ends at the least r. For lambda >= 0 height and slope grow with r (L5); for -1
/// <= lambda < 0 the state after the first collision does (L10).
template <class I>
Ray<I> lowest_over(const ScaledRay<I>& ray, const RatioRange<I>& range) {
    return at_ratio(ScaledRay<I>{low_end(ray.c), max(I(-1), low_end(ray.lambda))}, range.r_lo);
}

/// A single ray that lies above all of them: the upper ends at the greatest r.
template <class I>
Ray<I> highest_over(const ScaledRay<I>& ray, const RatioRange<I>& range) {
    return at_ratio(ScaledRay<I>{high_end(ray.c), high_end(ray.lambda)}, range.r_hi);
}

}  // namespace dumbbell::flight
