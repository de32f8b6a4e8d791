#pragma once

#include "flight/batch/pack.hpp"
#include "number/sine_kernel.hpp"

namespace dumbbell::flight::batch {

template <class D>
struct SinCosOf {
    D sin;
    D cos;
};

/// Sine and cosine of x in [0, half_pi_hi], off by at most 4 u relatively (L14 (b)), and never negative.
template <class D>
[[nodiscard]] SinCosOf<D> sin_cos(D x) {
    const Mask<D> near = x <= D(quarter_pi);
    const D y = select(near, x, (half_pi_hi - x) + half_pi_lo);
    const D s = sin_kernel(y);
    const D c = cos_kernel(y);
    return {select(near, s, c), select(near, c, s)};
}

/// Sine and cosine of z + shift, a double, from those of z, for |shift| up to 2^-13 and 2^-8 times both: off
/// by at most 5.4 u relatively (L39 (h)).
template <class D>
[[nodiscard]] SinCosOf<D> moved(const SinCosOf<D>& at, D shift) {
    const D half = 0.5 * (shift * shift);
    const D odd = shift - (half * shift) * (1.0 / 3);
    return {at.sin + (at.cos * odd - at.sin * half), at.cos - (at.sin * odd + at.cos * half)};
}

}  // namespace dumbbell::flight::batch
