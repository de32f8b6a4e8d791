#pragma once

#include <string>
#include <vector>

#include "certificate/certificate.hpp"

namespace dumbbell {

/// The staircase of a certificate over its range, with the source paper's bound above it, as a self-contained
/// SVG (logarithmic mass ratio). Gap pieces show as vertical steps; open pieces as hatched blanks.
/// Precondition: at least one piece, q_lo < q_hi.
[[nodiscard]] std::string staircase_svg(const std::vector<Piece>& pieces);

}  // namespace dumbbell
