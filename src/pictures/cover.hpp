#pragma once

#include <cstddef>
#include <string>

#include "collisions/certificate.hpp"
#include "pictures/svg.hpp"

namespace dumbbell::pictures {

inline constexpr std::size_t most_drawn_boxes = 100'000;

/// The boxes of a piece's cover at one mass ratio as a self-contained SVG: a frame for each chart, in its
/// coordinates (format.md, format-sections.md), each box coloured by the number of collisions that it
/// proves, or by its other reason; the witness is marked. Preconditions: the piece has an upper bound, of the
/// dumbbell, and q_lo <= q <= q_hi. Throws InputError if it has no boxes, or more than most_drawn_boxes.
[[nodiscard]] std::string cover_svg(const collisions::Piece& piece, const Rational& q);

/// The colour of boxes with a reason other than a count.
[[nodiscard]] Shade shade_of(collisions::Reason reason);

}  // namespace dumbbell::pictures
