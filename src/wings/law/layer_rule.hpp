#pragma once

#include "number/interval.hpp"

/// One step of an orbit in the layer U <= 9/10 (proofs/law.md, L49, L50 and L57): its defect D against the
/// comparison function D0(T) = k0 s (sqrt T - sqrt(T - 1))^3.
namespace dumbbell::law {

/// Steps with mid-point U and half width d = rho U, in units that leave no eps: it is rho U^2 ehat.
struct LayerBox {
    Interval U;    ///< in [0, 9/10]
    Interval rho;  ///< in [0, 1/5]
};

/// by_rho rho + by_U U, of which a leaf claims that it is not negative.
struct Margin {
    Interval by_rho, by_U, sum;
};

/// What is enclosed of all states of a box as (C5) to (C8) of proofs/law.md have them.
struct LayerBounds {
    Interval rest;    ///< 2 ((1 + rho)^2 k1 - 2 rho ehat)/((1 - rho)^2 ehat), which must be positive: T > 1
    Interval excess;  ///< (1 - D/D0(T))/y - 5/(3 pi)
    Margin above, below;  ///< that less its lower bound (C6), and its upper bound (C7) less that
    Interval drift;       ///< a/(2 ehat^2): J falls by eps^2 drift U^-4 per unit of u
    Interval at_zero;     ///< D/D0(T) at U = 0, which is 1
    Interval first;       ///< its derivative there less that of L57, which is 0
};
[[nodiscard]] LayerBounds layer_bounds(const LayerBox& box);

/// Whether eps > 1/1000 for every step of the box, by the first window of Q alone.
[[nodiscard]] bool certainly_beyond(const LayerBox& box);

/// Whether the rule proves all that a leaf claims, (C5) to (C8) of proofs/law.md, with a little to spare for
/// another arithmetic.
[[nodiscard]] bool closes(const LayerBox& box);

}  // namespace dumbbell::law
