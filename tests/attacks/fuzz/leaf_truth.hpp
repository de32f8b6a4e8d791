// What a leaf says of a state, against the simulated trajectory through that state (tests/attacks/oracle:
// other coordinates, no formula in common).
#pragma once

#include <optional>
#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell_fuzz {

using Real = long double;

/// A state in the coordinates of a chart (format.md, section 3; format-sections.md).
struct ChartState {
    Real position = 0;
    Real slope = 0;
    Real ratio = 1;
};

/// Collisions that a leaf of this chart limits: of the whole trajectory, with this one, where leaves count
/// both ways; else of the future alone.
struct Seen {
    long collisions = 0;
    bool heavy_again = false;  ///< the future has a collision of the heavy mass
};

/// Nothing if the state is none of those that the chart is about, or so close to that, to a corner or to a
/// tangency that the simulation may be wrong.
[[nodiscard]] std::optional<Seen> simulated(dumbbell::collisions::Chart chart, const ChartState& state);

/// Ends the program if the leaf is certainly wrong about the state.
void must_hold(dumbbell::collisions::Chart chart, const dumbbell::collisions::Leaf& leaf,
               const ChartState& state);

/// Ends the program if the witness certainly has fewer collisions at this ratio than it says.
void must_hold(const dumbbell::collisions::Witness& witness, Real ratio);

}  // namespace dumbbell_fuzz
