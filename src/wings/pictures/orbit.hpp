#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collisions/certificate.hpp"
#include "flight/orbit.hpp"
#include "number/rational.hpp"

namespace dumbbell::pictures {

inline constexpr std::size_t most_drawn_collisions = 20'000;

/// The orbit of the piece's witness at one of its mass ratios, drawn as below. Throws InputError if it has
/// none, if that cannot be enclosed, or beyond most_drawn_collisions.
[[nodiscard]] std::string orbit_svg(const collisions::Piece& piece, const Rational& q);

/// An enclosed orbit at one mass ratio as a self-contained SVG: the point (psi, y), psi = phi - pi/2, that
/// flies straight above the floor (theory: light walls and the bridge of the heavy mass) with its collisions
/// numbered; the same near the bridge where that is low; and the dumbbell at its collisions. Of many flights
/// and collisions some are drawn, and the caption says which. Each collision is drawn at the middle of its
/// enclosure; the caption says how wide those are at most. Precondition: not empty.
[[nodiscard]] std::string orbit_svg(const std::vector<flight::Collision<Interval>>& orbit, const Rational& q);

}  // namespace dumbbell::pictures
