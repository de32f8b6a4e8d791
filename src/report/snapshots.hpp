#pragma once

#include <vector>

#include "arith/rational.hpp"
#include "model/orbit.hpp"
#include "report/svg.hpp"

namespace dumbbell {

/// How much room draw_snapshots needs: nothing if there are too many collisions for it.
[[nodiscard]] double snapshots_height(const std::vector<Collision<Interval>>& orbit);

/// The dumbbell itself at each collision, side by side: the rod, the floor and the two masses (classes
/// `light` and `heavy`), the heavy one larger, numbered.
void draw_snapshots(Svg& svg, const std::vector<Collision<Interval>>& orbit, const Rational& q, double left,
                    double top, double width);

}  // namespace dumbbell
