#pragma once

#include "flight/batch/step.hpp"

namespace dumbbell::flight::batch {

/// The highest, steepest ray of a set, followed with upper bounds: its certain collisions are had by every
/// ray of the set.
struct Upper {
    static constexpr double pi = 2 * half_pi_above;

    /// By Taylor's formula g(z + d) >= g(z) + p d - d^2/2: where that is positive all rays collide, at x <= z
    /// + d (L12 (b)).
    template <class D>
    [[nodiscard]] static Contact<D> contact(D z, const SinCosOf<D>& at, D c, D kappa) {
        const D line = kappa * z;
        const D g = ((at.sin - line) - c) - padding(at.sin + abs(line) + c);  // from below
        const D slope = at.cos - kappa;
        const D slope_pad = padding(at.cos + abs(kappa));
        const D least_slope = slope - slope_pad;
        const D greatest_slope = slope + slope_pad;
        const D newton = -g / select(g < D(0.0), least_slope, greatest_slope);
        const D margin = abs(newton) * 0x1p-46 + newton * newton / least_slope + 0x1p-900;
        const D shift = max(newton + margin, -z);
        const D line_up = select(shift > D(0.0), least_slope, greatest_slope) * shift;
        const D square = shift * shift;
        const D value = ((g + line_up) - 0.5 * square) - padding(abs(g) + abs(line_up) + square);
        const Mask<D> certain = least_slope > D(0.0) && value > D(0.0) && z + shift < D(half_pi_hi);
        return {shift, certain && abs(shift) <= D(0x1p-25), Lanes<D>::none()};
    }

    template <class D>
    [[nodiscard]] static Bounce<D> bounce(D z, const SinCosOf<D>& at, D shift, D kappa, D r) {
        // sin(z + d) lies below its tangent, and cos(z + d) >= cos z - d sin z - d^2/2.
        const D rise = at.cos * shift;
        const D sine = (at.sin + rise) + padding(at.sin + abs(rise));
        const D fall = at.sin * shift;
        const D bend = 0.5 * (shift * shift);
        const D w = ((at.cos - fall) - bend) - padding(at.cos + abs(fall) + bend);

        const D product = w * (w - 2.0 * kappa);
        const D denominator = (product - r) - padding(abs(product) + r);
        const D first = (kappa * w) * w;
        const D second = r * (2.0 * w - kappa);
        const D numerator = (first + second) + padding(abs(first) + abs(second));
        const D next = numerator / denominator;
        const D height = sine + next * ((z + shift) + pi);
        const Mask<D> stays = w > D(0.0) && denominator > D(0.0);
        return {height, next, !stays, stays, at.cos - kappa > D(0x1p-10) && denominator > product * 0x1p-10};
    }

    template <class D>
    [[nodiscard]] static D undecided(D count, D /*cap*/) {
        return count;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D count, D cap) {
        return count >= cap;
    }
};

}  // namespace dumbbell::flight::batch
