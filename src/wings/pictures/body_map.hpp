#pragma once

#include <string>
#include <vector>

#include "collisions/certificate.hpp"

namespace dumbbell::pictures {

/// The plane of all rigid bodies, rho and Q (L70), as a self-contained SVG. Of each piece a strip of
/// bodies of one rho, or a disc for a single one, has the colour of its proved maximum; what has more than
/// one possible value is hatched. Drawn beside them: the massless dumbbells, Q rho = 1; rods of growing mass
/// between ends of the mass ratios 1, 3 and 10, L70 (d); the ring, the uniform rod and the coin.
/// Precondition: all are certificates of the scene body, at least one.
[[nodiscard]] std::string body_map_svg(const std::vector<collisions::Certificate>& certificates);

}  // namespace dumbbell::pictures
