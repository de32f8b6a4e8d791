#pragma once

#include <string>

#include "starts/cover/certificate.hpp"

namespace dumbbell::pictures {

/// The phase portrait of a certificate about initial conditions: regions of equal certified number of
/// collisions, united exactly, as a self-contained SVG. What is not decided is what no region covers:
/// hatched. The shares in the legend are rounded. Throws InputError unless exactly two of the five quantities
/// are intervals, or if there are more leaves than most_phase_leaves.
[[nodiscard]] std::string phase_svg(const starts::Certificate& certificate);

inline constexpr std::size_t most_phase_leaves = 200'000;

}  // namespace dumbbell::pictures
