#pragma once

#include "flight/batch/count_lanes.hpp"

/// What the batch kernel would be if nobody had to believe it: the same guesses, the same queue of rays, but
/// Newton's step and the reflection without a pad. What is left between the two is the price of the proof.
namespace dumbbell_bench {

struct Plain {
    template <class D>
    using Mask = dumbbell::flight::batch::Mask<D>;

    static constexpr double outward = 1;

    template <class D>
    [[nodiscard]] static auto contact(const dumbbell::flight::batch::Place<D>& place, D c, D kappa) {
        using dumbbell::flight::batch::abs;
        const D shift = (c - (place.at.sin - kappa * place.z)) * place.inverse;
        return dumbbell::flight::batch::Contact<D>{shift, abs(shift) <= D(0x1p-17)};
    }

    template <class D>
    [[nodiscard]] static auto bounce(D z, const dumbbell::flight::batch::SinCosOf<D>& at, D shift, D kappa,
                                     D r) {
        const D sine = at.sin + at.cos * shift;
        const D w = at.cos - at.sin * shift;
        const D denominator = w * (w - 2.0 * kappa) - r;
        const D next = (kappa * w * w + r * (2.0 * w - kappa)) / denominator;
        const Mask<D> leaves = denominator <= D(0.0);
        return dumbbell::flight::batch::Bounce<D>{sine + next * ((z + shift) + 2 * dumbbell::half_pi_hi),
                                                  next,
                                                  {sine, w},
                                                  leaves,
                                                  !leaves,
                                                  leaves && !leaves};
    }

    template <class D>
    [[nodiscard]] static D undecided(D left) {
        return left;
    }
    template <class D>
    [[nodiscard]] static Mask<D> full(D left) {
        return left < D(0.0);
    }
};

}  // namespace dumbbell_bench
