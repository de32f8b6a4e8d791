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

/// To 8 digits, by minimax polynomials on [0, pi/2]: for guesses.
template <class D>
[[nodiscard]] SinCosOf<D> rough_sin_cos(D x) {
    const D y = x * x;
    const D y2 = y * y;
    const D s = (0.99999999468600731 + y * -0.16666656684007140) +
                y2 * ((8.3330251389691998e-3 + y * -1.9807418727418191e-4) + y2 * 2.6019030676357846e-6);
    const D c = (0.99999995346667014 + y * -0.49999905347076734) +
                y2 * ((4.1663584693107908e-2 + y * -1.3853703708332223e-3) + y2 * 2.3153931659058715e-5);
    return {x * s, c};
}

}  // namespace dumbbell::flight::batch
