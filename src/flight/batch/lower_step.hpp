#pragma once

#include "flight/batch/step.hpp"

namespace dumbbell::flight::batch {

/// The lowest, flattest ray of a set, followed with lower bounds: its count is at least that of every ray of
/// the set.
struct Lower {
    static constexpr double pi = 2 * half_pi_hi;

    /// From the tangent at z (L12 (a)): x >= z + shift for every ray that collides.
    template <class D>
    [[nodiscard]] static Contact<D> contact(D z, const SinCosOf<D>& at, D c, D kappa) {
        const D line = kappa * z;
        const D g = ((at.sin - line) - c) + padding(at.sin + abs(line) + c);  // from above
        const D slope = at.cos - kappa;
        const D slope_pad = padding(at.cos + abs(kappa));
        const D least_slope = slope - slope_pad;
        const D newton = g / select(g >= D(0.0), least_slope, slope + slope_pad);
        const D shift = max(-newton, -z);
        const Mask<D> certain = least_slope > D(0.0);
        return {shift, certain && abs(shift) <= D(0x1p-25), certain && z + shift > D(half_pi_above)};
    }

    template <class D>
    [[nodiscard]] static Bounce<D> bounce(D z, const SinCosOf<D>& at, D shift, D kappa, D r) {
        // sin(z + d) >= sin z + d cos z - d^2/2 (z + |d|), and cos(z + d) lies below its tangent.
        const D rise = at.cos * shift;
        const D bend = 0.5 * (shift * shift) * (z + abs(shift));
        const D sine = (at.sin + rise) - (bend + padding(at.sin + abs(rise) + bend));
        const D fall = at.sin * shift;
        const D w = (at.cos - fall) + padding(at.cos + abs(fall));

        const D product = w * (w - 2.0 * kappa);
        const D denominator = (product - r) + padding(abs(product) + r);
        const D first = (kappa * w) * w;
        const D second = r * (2.0 * w - kappa);
        const D numerator = (first + second) - padding(abs(first) + abs(second));
        const D next = numerator / denominator;
        const D height = max(sine, D(0.0)) + next * ((z + shift) + pi);
        const Mask<D> leaves = denominator <= D(0.0);  // L1
        return {height, next, leaves, numerator > D(0.0) && !leaves,
                at.cos - kappa > D(0x1p-10) && denominator > product * 0x1p-10};
    }

    /// The answer, with `count` collisions up to now, if nothing more is certain.
    template <class D>
    [[nodiscard]] static D undecided(D /*count*/, D cap) {
        return cap + 1.0;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D count, D cap) {
        return count > cap;
    }
};

}  // namespace dumbbell::flight::batch
