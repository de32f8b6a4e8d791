// What a claim about initial conditions says of a start, against the simulated trajectory
// (tests/attacks/oracle).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "attacks/oracle/simulate.hpp"

namespace dumbbell_fuzz {

using Real = long double;
using Run = dumbbell_oracle::Run<Real>;

/// phi, phidot, y, ydot, q.
using Start = std::array<Real, 5>;

/// The trajectory from the start on. Nothing if it starts on or in the floor, hardly moves, or comes so close
/// to a corner or to a tangency that the simulation may be wrong.
[[nodiscard]] std::optional<Run> simulated(const Start& start);

/// Ends the program unless the trajectory has at least `least` and at most `most` collisions.
void must_be_between(const Run& run, std::uint64_t least, const std::optional<std::uint64_t>& most,
                     const Start& start);

}  // namespace dumbbell_fuzz
