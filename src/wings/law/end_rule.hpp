#pragma once

#include "number/interval.hpp"

/// The end of an orbit at a critical ratio (proofs/law.md, L52): its last contact at u_b = 2d, after which
/// the flight is tangent.
namespace dumbbell::law {

struct EndBounds {
    Interval surplus;  ///< (e_end - k0 s)/eps, s = sqrt(eps)
    Interval at_zero;  ///< e_end/s at d = 0, which is k0
};

/// Of d in this interval, in [0, 0.09], with the J of its contact in pi/2 + [-5.3 eps^2/u_b^3, eps^2/4].
[[nodiscard]] EndBounds end_bounds(const Interval& d);

/// Whether eps > 1/1000 for every d of the interval, by the first window of Q alone, pi/2 + [-1/100, 1/20].
[[nodiscard]] bool certainly_beyond(const Interval& d);

}  // namespace dumbbell::law
