#pragma once

#include "flight/body.hpp"

/// Reflections off the three walls, in units of the theory: slopes kappa, or lambda = kappa / r
/// (proofs/lemmas.md, L4, L8, L9).
namespace dumbbell::flight {

/// The reflection of a ray of slope kappa at a light wall of slope w = cos x, formula (2) of L4: it stays in
/// the cell iff `denominator` > 0, and then leaves with slope numerator / denominator.
template <class I>
struct LightReflection {
    I numerator;
    I denominator;
};

template <class I>
LightReflection<I> reflect_at_light_wall(const I& kappa, const I& w, const I& r) {
    const I w_squared = sqr(w);
    const I two = I(2);
    return {kappa * w_squared + r * (two * w - kappa), w_squared - two * kappa * w - r};
}

/// The reflection of a slope kappa = d yhat / d phi where `end` touches, c = cos phi: numerator /
/// denominator, the denominator having the sign of phidot' times that of phidot. With the end's leverage l
/// and weight w it is (-+2 r c - kappa (w - l c^2)) / (w - l c^2 -+ 2 kappa c): - at the light end, + at the
/// bridge; there it decreases with kappa and increases with c where the denominator keeps its sign (L60 (c)).
template <class I>
LightReflection<I> reflect_at_end(End end, const I& kappa, const I& c, const Body<I>& body) {
    const I rest = body.weight(end) - body.leveraged(end, sqr(c));
    return {-turned(end, I(2) * body.r * c) - kappa * rest, rest - kappa * turned(end, I(2) * c)};
}

/// The reversed incoming ray at a light wall in units of r (L9): D = w^2 + 2 r lambda w - r and P = 2 w + r
/// lambda - lambda w^2; it ascends iff P > 0, flies to the other wall iff D > 0, and then has slope r mu, mu
/// = P / D.
template <class I>
LightReflection<I> reversed_at_light_wall(const I& lambda, const I& w, const I& r) {
    const I w_squared = sqr(w);
    const I two = I(2);
    return {two * w + lambda * (r - w_squared), w_squared + two * r * lambda * w - r};
}

/// The steepness eta' of the reversed incoming ray over the bridge's tangent, formula (3) of L8, from the
/// outgoing ray's eta >= 0. s = sin psi of the contact. Decreases with r, increases with eta.
template <class I>
I reversed_steepness(const I& eta, const I& s, const I& r) {
    const I base = I(1) + r * sqr(s);
    return eta * base / (base + I(2) * r * s * eta);
}

}  // namespace dumbbell::flight
