#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dumbbell/interval.hpp"
#include "dumbbell/mass_ratio.hpp"
#include "dumbbell/stopped.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// A dumbbell in the air, or a box of them: each quantity an exact number as written (`3`, `-0.5`, `1/3`) or
/// a closed interval `LO:HI`. The rod has length 1; phi is its angle in radians, in degrees (`30deg`) or as a
/// multiple of pi (`pi/2`, `2pi/3`, `0.3pi`), y the height of the centre of mass: the light mass is at height
/// y + q/(1+q) sin phi, the heavy one at y - 1/(1+q) sin phi.
struct InitialCondition {
    std::string phi, phidot, y, ydot;
};

/// One collision of every orbit of the box. Time counts from the start. grazing_sine is the sine of the angle
/// between flight and floor in the metric of the kinetic energy: 1 head-on, near 0 where the mass only just
/// touches.
struct Collision {
    bool heavy = false;
    Interval time, phi, y;
    Interval phidot_before, phidot_after;
    Interval ydot_before, ydot_after;
    Interval grazing_sine;
};

/// Every orbit of the box has at least `least` collisions in all, and at most `most` (nothing is known if
/// empty). `collisions` are those that can be enclosed, in the order of time.
struct Trace {
    long least = 0;
    std::optional<long> most;
    std::vector<Collision> collisions;
};

/// Follows the orbits through all their collisions. digits = 0 computes in double precision, otherwise with a
/// precision for this number of decimal digits, which decides more. Stopped, it knows the collisions so far.
///
/// Throws InputError, naming the quantity, for what is no number, a mass below the floor, a dumbbell at rest,
/// values absurdly large, and digits outside [0, 100000].
[[nodiscard]] [[gnu::visibility("default")]] Trace trace(const MassRatio& ratio,
                                                         const InitialCondition& start, int digits = 0,
                                                         const Stopped& stopped = {});

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
