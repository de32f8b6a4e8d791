#pragma once

#include <utility>

#include "collisions/certificate.hpp"
#include "collisions/coordinate.hpp"

namespace dumbbell::collisions {

/// A box of states, exact: corner distance e, slope coordinate (eta in the chart bridge, lambda in the chart
/// light), mass ratio; of bodies also rho, which is 0 for others.
struct Box {
    Coordinate e_lo, e_hi;
    Coordinate slope_lo, slope_hi;
    Coordinate q_lo, q_hi;
    Coordinate rho_lo = 0, rho_hi = 0;
};

/// The root box of a chart over mass ratios [q_lo, q_hi] (format.md): short dyadics that contain the
/// chart's states, e in [0, 2] (t in [0, 4]; the chart wedge has no position), and a slope range that holds
/// all slopes in play.
[[nodiscard]] Box root_box(Chart chart, const Rational& q_lo, const Rational& q_hi);

/// The lower and the upper half; the midpoint is exact and belongs to both.
[[nodiscard]] std::pair<Box, Box> halves(const Box& box, Axis axis);

}  // namespace dumbbell::collisions
