#pragma once

#include <string>
#include <vector>

#include "flight/orbit.hpp"
#include "words/json.hpp"

namespace dumbbell::collisions {

/// A line per collision, in the order of time: mass, time, phi, height and velocities, each enclosed.
[[nodiscard]] std::string collisions_text(const std::vector<flight::Collision<Interval>>& orbit);

/// How wide the enclosures are along the orbit: a line for collisions 1, 10, 100, ... and the last, and for
/// the widest of each column.
[[nodiscard]] std::string widths_text(const std::vector<flight::Collision<Interval>>& orbit);

/// An object per collision; every enclosure is a pair of doubles, exactly the computed ones.
[[nodiscard]] Json collisions_json(const std::vector<flight::Collision<Interval>>& orbit);

}  // namespace dumbbell::collisions
