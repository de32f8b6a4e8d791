#pragma once

#include <string>
#include <vector>

#include "collisions/cell_reader.hpp"

namespace dumbbell::pictures {

/// The plane of all rigid bodies, log rho and log Q (L70), as a self-contained SVG: rho from 1/100 to 1, Q
/// from 1 to 100, and more if the cells reach beyond. Cells of one N are united, exactly, and have its colour
/// and its name. Those with more than one possible N enclose the steps, and are coloured by what steps:
/// ceil(pi/corner) or something else. Beside them: the massless rods, Q rho = 1; rods of growing mass, L70
/// (d); the ring, the uniform rod and the coin.
[[nodiscard]] std::string body_map_svg(const std::vector<collisions::Cell>& cells);

}  // namespace dumbbell::pictures
