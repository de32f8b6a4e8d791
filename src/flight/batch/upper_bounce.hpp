#pragma once

#include "flight/batch/bounce.hpp"

namespace dumbbell::flight::batch {

/// The highest, steepest ray of a set, followed with upper bounds: its certain collisions are had by every
/// ray of the set.
struct Upper {
    static constexpr double pi = 2 * half_pi_above;
    static constexpr double outward = 1 + relative_pad;

    /// By Taylor's formula g(z + d) >= g(z) + p d - d^2/2: where that is positive all rays collide, at x <= z
    /// + d.
    template <class D>
    [[nodiscard]] static Contact<D> contact(const Place<D>& place, D c, D kappa) {
        const auto& [z, at, inverse, least] = place;
        const D line = kappa * z;
        const D gap = (c - (at.sin - line)) + padding(at.sin + abs(line) + c);  // from above
        const D newton = gap * inverse;
        const D curve = abs(newton) * inverse;
        const D shift = newton + abs(newton) * (curve + 0x1p-15);
        return {shift, small(shift, place) && curve <= D(0.25) && z + shift < D(half_pi_hi)};
    }

    template <class D>
    [[nodiscard]] static Bounce<D> bounce(D z, const SinCosOf<D>& at, D shift, D kappa, D r) {
        // sin(z + d) lies below its tangent, and cos(z + d) hardly below.
        const D sine = (at.sin + at.cos * shift) + padding(at.sin);
        const D w = (at.cos - at.sin * shift) - at.cos * relative_pad;

        const D product = w * (w - 2.0 * kappa);
        const D denominator = product * (1 - relative_pad) - r;
        const D first = (kappa * w) * w;
        const D numerator = (first + abs(first) * relative_pad) + r * (2.0 * w - kappa);
        const D next = numerator / denominator;
        const D height = sine + next * ((z + shift) + pi);
        const Mask<D> stays = w > D(0.0) && denominator > D(0.0);
        return {height, next,  {sine, w},
                !stays, stays, at.cos - kappa > D(0x1p-10) && denominator > product * 0x1p-10};
    }

    template <class D>
    [[nodiscard]] static D undecided(D left) {
        return left;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D left) {
        return left <= D(0.0);
    }
};

}  // namespace dumbbell::flight::batch
