// One collision of the light mass: its law, and the errors of L38.
#pragma once
#include "verify/wings/adiabatic/contact.hpp"

namespace dumbbell_verify::adiabatic {

/// D: the spin changes by the factor -D/(w^2 + r).
template <class N>
Interval<N> onward(const Masses<N>& m, const Interval<N>& w, const Interval<N>& kappa) {
    return square(w) - Interval<N>(2) * kappa * w - m.r;
}
/// Encloses the slope after a collision with D > 0: it grows with kappa and r and falls with w (L5 (b)).
/// Unbounded on a side where D is not certainly positive, as a quotient is.
template <class N>
Interval<N> slope_behind(const Masses<N>& m, const Interval<N>& w, const Interval<N>& kappa) {
    using I = Interval<N>;
    const auto at = [](const I& cosine, const I& k, const I& r) {
        return (k * square(cosine) + I(2) * r * cosine - r * k) / (square(cosine) - I(2) * k * cosine - r);
    };
    return span(at(w.hi, kappa.lo, m.r.lo).lo, at(w.lo, kappa.hi, m.r.hi).hi);
}

/// The height at the far corner after such a collision. It grows with kappa and r, as the slope k' does, and
/// with x, since so does k' (L5 (b)) and cos x + k' > 0 (L33): so it lies between its values at two ends.
template <class N>
Interval<N> corner_behind(const Touch<N>& at, const Interval<N>& slope) {
    using I = Interval<N>;
    const auto height = [](const N& sine, const N& k, const N& x) { return sine + I(k) * (x + pi<N>()); };
    return span(height(at.sine.lo, slope.lo, at.x.lo).lo, height(at.sine.hi, slope.hi, at.x.hi).hi);
}

/// E1 for kappa <= 0.
template <class N>
Interval<N> error_of_spin(const Masses<N>& m, const Touch<N>& at, const Interval<N>& kappa) {
    using I = Interval<N>;
    const I square_sum = at.square_w + m.r;
    const I steep = -kappa * square(m.r) * square(at.sine) / (at.rho * (square_sum + at.w * at.rho));
    return I(2) * (m.r + steep) / square_sum;
}

/// E2 without its sign: climb = -ydot = delta s; the next collision is at corner distance `next`, behind a
/// flight of this slope. Precondition: D > 0.
template <class N>
Interval<N> error_of_height(const Masses<N>& m, const Touch<N>& at, const Interval<N>& climb,
                            const Interval<N>& kappa, const Interval<N>& slope, const Interval<N>& next) {
    using I = Interval<N>;
    const I quarter = pi<N>() / I(2), way = quarter + quarter + at.x + next;
    // x' - x, and again by the mean value theorem for sin x' - sin x = slope (pi + x + x').
    I shift = next - at.x;
    const I cosine = sin_cos_on(hull(at.x, next), quarter).cos;
    if (cosine.lo > N(0)) shift = meet(shift, slope * way / cosine);
    return -(climb * (shift + I(2) * at.asin_Z)) +
           I(2) * m.beta2 * at.w * (m.r + square(kappa)) * way / onward(m, at.w, kappa);
}

}  // namespace dumbbell_verify::adiabatic
