#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "collisions/witness.hpp"

namespace dumbbell::starts {

/// Of longer orbits no start is looked for: it would take minutes.
inline constexpr long longest_witness = 5000;

/// A start near the witness's orbit, before its first collision. `trace` was run on it: it has exactly as
/// many collisions at q as the witness. Nothing if no such start of up to 256 digits is found, if the witness
/// is longer than that, or if interrupted.
[[nodiscard]] std::optional<collisions::WitnessStart> witness_start(const collisions::Witness& witness,
                                                                    const Rational& q,
                                                                    const Interrupted& interrupted = never);

}  // namespace dumbbell::starts
