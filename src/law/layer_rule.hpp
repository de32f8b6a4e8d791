#pragma once

#include "number/interval.hpp"

/// One step of an orbit in the layer U <= 9/10 (proofs/law.md, L49 and L50): its defect D against the
/// comparison function D0(T) = k0 s (sqrt T - sqrt(T - 1))^3.
namespace dumbbell::law {

/// Steps with mid-point U and half width d = rho U, in units that leave no eps: it is rho U^2 ehat.
struct LayerBox {
    Interval U;    ///< in [0, 9/10]
    Interval rho;  ///< in [0, 1/5]
};

enum class LayerForm { slope, direct };

/// What is enclosed of all states of a box as (C5) to (C8) of proofs/law.md have them.
struct LayerBounds {
    Interval rest;     ///< (1 + rho)^2 k1 - 2 rho ehat, which must be positive: then T > 1
    Interval gamma;    ///< (1 - D/D0(T))/U
    Interval drift;    ///< a/(2 ehat^2): J falls by eps^2 drift U^-4 per unit of u
    Interval at_zero;  ///< slope form: D/D0(T) at U = 0, which is 1
};
/// NaN where the form does not apply: the direct one at U = 0.
[[nodiscard]] LayerBounds layer_bounds(const LayerBox& box, LayerForm form);

/// Whether eps > 1/1000 for every step of the box, by the first window of Q alone.
[[nodiscard]] bool certainly_beyond(const LayerBox& box);

/// Whether the form proves all that a leaf claims, with a little to spare for another arithmetic:
/// (C5) to (C8) of proofs/law.md, 0 <= 1 - D/D0(T) <= 1.3 U, where U > 3/4 at most 1.11 U, and a/(2 ehat^2)
/// <= 15.9.
[[nodiscard]] bool closes(const LayerBox& box, LayerForm form);

}  // namespace dumbbell::law
