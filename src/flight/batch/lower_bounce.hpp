#pragma once

#include "flight/batch/bounce.hpp"

namespace dumbbell::flight::batch {

/// The lowest, flattest ray of a set, followed with lower bounds: its count is at least that of every ray of
/// the set.
struct Lower {
    static constexpr double pi = 2 * half_pi_hi;
    static constexpr double outward = 1 - relative_pad;

    /// From the tangent at z (L12 (a)): x >= z + shift for every ray that collides.
    template <class D>
    [[nodiscard]] static Contact<D> contact(const Place<D>& place, D c, D kappa) {
        const auto& [z, at, inverse, least] = place;
        const D line = kappa * z;
        const D gap = (c - (at.sin - line)) - padding(at.sin + abs(line) + c);  // from below
        const D newton = gap * inverse;
        const D shift = max(newton - abs(newton) * 0x1p-16, -z);
        return {shift, small(shift, place)};
    }

    template <class D>
    [[nodiscard]] static Bounce<D> bounce(D z, const SinCosOf<D>& at, D shift, D kappa, D r) {
        // cos(z + d) lies below its tangent, and sin(z + d) above that less d^2/2 sin z, but for a trace.
        const D sine = (at.sin + shift * (at.cos - (0.5 * shift) * at.sin)) - padding(at.sin);
        const D w = (at.cos - at.sin * shift) + at.cos * relative_pad;

        const D product = w * (w - 2.0 * kappa);
        const D denominator = product * (1 + relative_pad) - r;
        const D first = (kappa * w) * w;
        const D numerator = (first - abs(first) * relative_pad) + r * (2.0 * w - kappa);
        const D next = numerator / denominator;
        const D height = max(sine, D(0.0)) + next * ((z + shift) + pi);
        const Mask<D> leaves = denominator <= D(0.0);  // L1
        return {height,
                next,
                {sine, w},
                leaves,
                numerator > D(0.0) && !leaves,
                at.cos - kappa > D(0x1p-10) && denominator > product * 0x1p-10};
    }

    /// The collisions that are left up to the cap, which `left` are now, if nothing more is certain.
    template <class D>
    [[nodiscard]] static D undecided(D /*left*/) {
        return -1.0;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D left) {
        return left < D(0.0);
    }
};

}  // namespace dumbbell::flight::batch
