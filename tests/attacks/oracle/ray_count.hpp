// The ray iteration of format.md 3.2 in plain numbers (no enclosures), and the numbers of theory
// section 4 made from it. The simulation does not use it: tests compare the two.
#pragma once

#include <cstddef>
#include <optional>

#include "chart.hpp"

namespace dumbbell_oracle {

// Crosses the vertical through the corner before a light wall at height c with slope kappa.
template <class S>
struct Ray {
    S c;
    S kappa;
};

// Excess of the light wall over the ray at its best place in [0, pi/2]; the ray hits iff it is positive.
template <class S>
[[nodiscard]] S greatest_excess(const Ray<S>& ray);

// Least root x in [0, pi/2] of sin x = c + kappa x, if the ray hits.
template <class S>
[[nodiscard]] std::optional<S> hit_place(const Ray<S>& ray);

// Slope after the reflection at corner distance x; nothing if D <= 0 (the ray does not turn back).
template <class S>
[[nodiscard]] std::optional<S> slope_after(const S& kappa, const S& x, const S& r);

template <class S>
struct Step {
    S x;
    std::optional<Ray<S>> next;  // nothing if the ray leaves: D <= 0 or slope >= 1
};
template <class S>
[[nodiscard]] std::optional<Step<S>> step(const Ray<S>& ray, const S& r);  // nothing if it does not hit

// G(c, kappa, r). `margin`, if there is one, becomes the least distance of any decision from its turning
// point, if that is less.
template <class S>
[[nodiscard]] std::size_t ray_count(Ray<S> ray, const S& r, S* margin = nullptr);

// Lemma L8: the two rays of a contact with the bridge.
template <class S>
[[nodiscard]] Ray<S> bridge_ray(const BridgeState<S>& state, const S& r);
template <class S>
[[nodiscard]] Ray<S> bridge_ray_reversed(const BridgeState<S>& state, const S& r);

// Lemma L9: the two rays of a contact with R. `reversed` is empty if it does not go left.
template <class S>
[[nodiscard]] Ray<S> light_ray(const LightState<S>& state, const S& r);
template <class S>
[[nodiscard]] std::optional<Ray<S>> light_ray_reversed(const LightState<S>& state, const S& r);

// Theory section 4: k0 from the ray tangent to the top of the bridge, k1 from the corner along the bridge's
// tangent; N* = 2 + k0 + k1.
struct Theorem {
    std::size_t k0;
    std::size_t k1;
    [[nodiscard]] std::size_t maximum() const { return 2 + k0 + k1; }
};
template <class S>
[[nodiscard]] Theorem theorem(const S& ratio);

}  // namespace dumbbell_oracle
