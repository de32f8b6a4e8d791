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

}  // namespace dumbbell::flight::batch
