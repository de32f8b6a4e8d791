#pragma once

#include "adiabatic/masses.hpp"
#include "number/elementary.hpp"

/// A contact of the light mass and the mean invariant S there (proofs/adiabatic.md, L33).
namespace dumbbell::adiabatic {

/// At corner distance x: w = cos x, s = sin x, F = pi/2 + x, f = pi/2 + asin(beta2 s) = pi - arccos y.
template <class I>
struct LightContact {
    I x;
    I w;
    I s;
    I F;
    I f;
};

template <class I>
[[nodiscard]] LightContact<I> light_contact(const I& x, const I& beta2) {
    const SinCos<I> at = sin_cos(x);
    return {x, at.cos, at.sin, half_pi<I>() + x, half_pi<I>() + asin(beta2 * at.sin)};
}

/// h(x, kappa) = f w (w - kappa)/(w^2 + r): S over |phidot| before the contact, kappa the slope before it.
/// Precondition: w > 0.
template <class I>
[[nodiscard]] I mean_share(const LightContact<I>& at, const I& kappa, const I& r) {
    return at.f * (I(1) - kappa / at.w) / (I(1) + r / sqr(at.w));
}

/// g/delta of L33 (b) from kappa and kappa/delta, so that delta may be 0. Precondition: w > 0, w > kappa.
template <class I>
[[nodiscard]] I half_step(const I& w, const I& kappa, const I& kappa_over_delta, const I& delta_over_beta2) {
    return (delta_over_beta2 / w + kappa_over_delta) / (w - kappa);
}

}  // namespace dumbbell::adiabatic
