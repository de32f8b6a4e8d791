#pragma once

#include <vector>

#include "collisions/certificate.hpp"
#include "flight/orbit.hpp"

namespace dumbbell::collisions {

/// The witness's orbit at one mass ratio, every collision enclosed with `bits` of working precision and
/// rounded outward to double. Empty if that precision cannot enclose it. Throws InputError for more
/// collisions than anybody reads, 10^7.
[[nodiscard]] std::vector<flight::Collision<Interval>> witness_orbit(const Witness& witness,
                                                                     const Rational& q, int bits);

}  // namespace dumbbell::collisions
