#pragma once

namespace dumbbell::flight {

/// From a point with this sine and cosine to the contact, an error of fourth
/// order. `newton` is Newton's step, `inverse` 1/slope. A guess.
[[nodiscard]] inline double way_to_contact(double newton, double inverse, const SinCosGuess& at) {
    const double bend = (0.5 * at.sin) * inverse;
    const double twist = (at.cos * inverse) * (1.0 / 6);
    const double curved = newton + newton * (bend * newton);
    return newton + (curved * curved) * (bend + twist * curved);
}

}  // namespace dumbbell::flight
