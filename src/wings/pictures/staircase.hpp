#pragma once

#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell::pictures {

/// The staircase of a certificate of the dumbbell over its range as a self-contained SVG (logarithmic mass
/// ratio), with 2 + C sqrt q and the source paper's bound above it, or its value in words where it lies too
/// far above. A line is drawn only where one value is proved; gap pieces are filled between their two values;
/// open pieces are hatched. Counts that grow many times over are drawn by their logarithm. Precondition: at
/// least one piece, q_lo < q_hi. Throws InputError for a range narrower than doubles tell apart, and beyond
/// paper_bound_limit().
[[nodiscard]] std::string staircase_svg(const collisions::Certificate& certificate);

}  // namespace dumbbell::pictures
