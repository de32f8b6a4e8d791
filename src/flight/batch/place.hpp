#pragma once

#include "flight/batch/aim.hpp"

namespace dumbbell::flight::batch {

/// A point of [0, half_pi_hi] to lay the tangent at, for a ray of slope kappa.
template <class D>
struct Place {
    D z;
    SinCosOf<D> at;  ///< of z, off by at most 5.4 u relatively
    D inverse;       ///< 1/(cos z - kappa), which is positive, off by at most 2^-17 relatively
    D least;         ///< at most 2^-7 sin z and 2^-7 cos z
};

template <class D>
struct NearPlace {
    Place<D> place;
    Mask<D> near;  ///< the place is one
};

/// The point that a step from z leads to, if it is so near that sine and cosine of z, `at`, give
/// those of that point, and 1/(cos z - kappa) the other inverse: L39 (h).
template <class D>
[[nodiscard]] NearPlace<D> place_near(D z, const SinCosOf<D>& at, D c, D kappa) {
    const D slope = at.cos - kappa;
    const D inverse = 1.0 / slope;
    const D newton = (c - (at.sin - kappa * z)) * inverse;
    const D next = z + way_to_contact(newton, inverse, at);
    const D shift = next - z;
    const D least = min(at.sin, at.cos) * 0x1p-8;
    const D turn = (at.sin * shift) * inverse;  // by which the slope decreases on the way
    return {{next, moved(at, shift), inverse + inverse * (turn + turn * turn), least},
            abs(shift) <= min(min(least, D(0x1p-13)), slope * 0x1p-6) && slope > D(0x1p-24)};
}

}  // namespace dumbbell::flight::batch
