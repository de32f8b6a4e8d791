#pragma once

#include <array>

#include "starts/certificate.hpp"

namespace dumbbell::starts {

/// How much each axis of a box spreads its orbits where they part, which is after `shared` collisions, from
/// the derivatives of the orbit of its centre: a guess, for choosing the axis to halve. Precondition: the
/// centre is in the air.
[[nodiscard]] std::array<double, axis_count> spreads(const Box& box, long shared);

}  // namespace dumbbell::starts
