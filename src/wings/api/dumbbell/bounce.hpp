#pragma once

#include "dumbbell/interval.hpp"
#include "dumbbell/mass_ratio.hpp"

/// One bounce of the light mass, enclosed: lemmas L4 and L5 of proofs/lemmas.md.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// Flights towards a light wall, in the chart of lemma L4: with psi the rod's angle and yhat the height of
/// the centre of mass over the light mass's share of the rod, the flight crosses the vertical through the
/// corner before that wall at height c, and rises by kappa per radian of |psi|.
struct Ray {
    Interval c;
    Interval kappa;
};

/// The rays that leave a light wall for the other one, at corner distance x in [0, pi/2] (0: corner, pi/2:
/// peak) and with slope kappa: c = sin x + kappa (x + pi). Throws InputError if an interval is none, or x is
/// not in [0, pi/2].
[[nodiscard]] [[gnu::visibility("default")]] Ray ray_from_light_wall(const Interval& x,
                                                                     const Interval& kappa);

enum class Outcome {
    misses,    ///< no ray of the box meets the wall
    leaves,    ///< each collides, and never again
    flies_on,  ///< each collides, and flies back over the bridge, towards the other light wall
    undecided  ///< nothing is claimed: the box is too wide, or a ray touches the wall
};

struct Bounce {
    Outcome outcome = Outcome::undecided;
    Interval x;  ///< leaves, flies_on: the corner distance of every collision, sin x = c + kappa x
    Ray ray;     ///< flies_on: the reflected flights (mirrored)
};

/// The flight of all rays of a box to the light wall, and their reflection there, for every mass ratio of the
/// range.
///
/// The claim is about the rays with c >= 0 and kappa >= -1/q; of these, about the ones with kappa >= 0 or
/// c + kappa pi/2 < 1 (below the wall's peak). Whether the heavy mass touches the floor before is another
/// question: it does not after a collision with a light wall that `flies_on` (lemma L6). Throws InputError
/// if an interval is none (NaN, infinite, reversed).
[[nodiscard]] [[gnu::visibility("default")]] Bounce enclose_bounce(const MassRatio& ratio, const Ray& box);

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
