#pragma once

#include <optional>
#include <string>

#include "certificate/certificate.hpp"
#include "model/interrupted.hpp"

namespace dumbbell {

/// A dumbbell in the air, as decimals that mean exactly what they spell, in the units of `trace`: rod length
/// 1, phi in radians, y the height of the centre of mass.
struct WitnessStart {
    std::string phi, phidot, y, ydot;
    int digits = 0;  ///< that `trace` needs; 0: double precision suffices
};

/// A start near the witness's orbit, before its first collision. `trace` was run on it: it has exactly as
/// many collisions at q as the witness. Nothing if no such start of up to 256 digits is found, if the witness
/// has more than 5000 collisions, or if interrupted.
[[nodiscard]] std::optional<WitnessStart> witness_start(const Witness& witness, const Rational& q,
                                                        const Interrupted& interrupted = never);

}  // namespace dumbbell
