#pragma once

#include <utility>

#include "arith/rational.hpp"
#include "certificate/certificate.hpp"

namespace dumbbell {

/// A box of states, exact: corner distance e, slope coordinate (eta in the chart bridge, lambda in the chart
/// light), mass ratio.
struct Box {
    Rational e_lo, e_hi;
    Rational slope_lo, slope_hi;
    Rational q_lo, q_hi;
};

/// The root box of both charts over mass ratios [q_lo, q_hi]: e in [0, 2], slope in [0, 2^k], k >= 0 least
/// with 2^k >= q_hi. It contains the section: e <= pi/2 < 2, and kappa = r * slope coordinate < 1 for all
/// states in play.
[[nodiscard]] Box root_box(const Rational& q_lo, const Rational& q_hi);

/// The lower and the upper half; the midpoint is exact and belongs to both.
[[nodiscard]] std::pair<Box, Box> halves(const Box& box, Axis axis);

}  // namespace dumbbell
