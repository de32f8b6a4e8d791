#pragma once

namespace dumbbell::flight {

/// A flight towards a light wall, in the chart of lemma L4: it crosses the vertical through the corner before
/// that wall (psi = -pi/2 when it flies left) at height `c` >= 0 (0 is a bound: flights of regular
/// trajectories have c > 0), with slope `kappa` = d yhat / |d psi| in its direction of travel, and the mass
/// ratio is 1/`r`. By L5 a set of rays is bounded from below, and from above, by single rays: "lower" and
/// "flatter".
template <class I>
struct Ray {
    I c;
    I kappa;
    I r;
};

}  // namespace dumbbell::flight
