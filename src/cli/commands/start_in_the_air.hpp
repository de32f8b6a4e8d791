#pragma once

#include <optional>
#include <string>

#include "base/interrupted.hpp"
#include "collisions/witness.hpp"

namespace dumbbell::cli {

struct StartInTheAir {
    std::optional<collisions::WitnessStart> start;
    std::string why_none;  ///< empty if there is one
};

/// A start for `dumbbell trace` near a witness's orbit: the wing starts defines how it is found.
[[nodiscard]] StartInTheAir start_in_the_air(const collisions::Witness& witness, const Rational& q,
                                             const Interrupted& interrupted);

}  // namespace dumbbell::cli
