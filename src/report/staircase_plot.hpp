#pragma once

#include <string>
#include <vector>

#include "certificate/certificate.hpp"

namespace dumbbell {

/// The staircase of a certificate over its range as a self-contained SVG (logarithmic mass ratio), named
/// after its scene; for the dumbbell with the source paper's bound above it and with 2 + C sqrt q. Gap pieces
/// show as vertical steps; open pieces hatched. Many counts are drawn by their logarithm. Precondition: at
/// least one piece, q_lo < q_hi <= paper_bound_limit().
[[nodiscard]] std::string staircase_svg(const std::vector<Piece>& pieces, Scene scene);

}  // namespace dumbbell
