#pragma once

#include "flight/batch/count_lanes.hpp"
#include "flight/batch/packs.hpp"

/// What the batch kernel would be if nobody had to believe it: the same guesses, the same queue of rays, but
/// Newton's step and the reflection without a pad. What is left between the two is the price of the proof.
namespace dumbbell_bench {

struct Plain {
    template <class D>
    using Mask = dumbbell::flight::batch::Mask<D>;

    template <class D>
    [[nodiscard]] static auto contact(D z, const dumbbell::flight::batch::SinCosOf<D>& at, D c, D kappa) {
        using dumbbell::flight::batch::abs;
        const D slope = at.cos - kappa;
        const D shift = ((c + kappa * z) - at.sin) / slope;
        const Mask<D> meets = slope > D(0.0);
        return dumbbell::flight::batch::Contact<D>{shift, meets && abs(shift) <= D(0x1p-17),
                                                   meets && z + shift > D(dumbbell::half_pi_hi)};
    }

    /// Sine and cosine at the contact from those at z, by Taylor's formula.
    template <class D>
    [[nodiscard]] static auto bounce(D z, const dumbbell::flight::batch::SinCosOf<D>& at, D shift, D kappa,
                                     D r) {
        // The rest of the third-order step: the contact is where Newton's leaves half of sin z shift^2 /
        // slope.
        const D d = shift + 0.5 * (shift * shift) * at.sin / (at.cos - kappa);
        const D half = 0.5 * (d * d);
        const D sine = at.sin + (at.cos * d - at.sin * half);
        const D w = at.cos - (at.sin * d + at.cos * half);
        const D denominator = w * (w - 2.0 * kappa) - r;
        const D next = (kappa * w * w + r * (2.0 * w - kappa)) / denominator;
        const Mask<D> leaves = denominator <= D(0.0);
        return dumbbell::flight::batch::Bounce<D>{sine + next * ((z + d) + 2 * dumbbell::half_pi_hi), next,
                                                  leaves, !leaves, leaves && !leaves};
    }

    template <class D>
    [[nodiscard]] static D undecided(D count, D /*cap*/) {
        return count;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D count, D most) {
        return count > most;
    }
};

}  // namespace dumbbell_bench
