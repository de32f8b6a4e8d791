#pragma once

#include <cstddef>
#include <vector>

#include "flight/orbit.hpp"
#include "number/rational.hpp"
#include "pictures/svg.hpp"

namespace dumbbell::pictures {

/// Which collisions of an orbit a strip shows, in order: all of a few; of many the first ones, those around
/// the turn (the contact of the heavy mass, or the lowest), and the last ones.
[[nodiscard]] std::vector<std::size_t> shown_collisions(
    const std::vector<flight::Collision<Interval>>& orbit);

/// The index of that turn. Precondition: not empty.
[[nodiscard]] std::size_t turn_of(const std::vector<flight::Collision<Interval>>& orbit);

[[nodiscard]] double snapshots_height();

/// The dumbbell itself at each of shown_collisions, side by side: the rod, the floor and the two masses
/// (classes `light` and `heavy`), the heavier one larger, numbered; dots where others are left out.
void draw_snapshots(Svg& svg, const std::vector<flight::Collision<Interval>>& orbit, const Rational& q,
                    double left, double top, double width);

}  // namespace dumbbell::pictures
