#pragma once

#include <cstddef>

/// What the file format allows (docs/reference/format.md): each figure once.
namespace dumbbell {

/// Of a piece, or of a cover: the precision that the verifier may need.
inline constexpr int most_file_bits = 4096;

/// Of the angles of a start.
inline constexpr int most_angle_bits = 3000;

/// A line, with its end.
inline constexpr std::size_t longest_line_in_file = 4096;

/// Boxes of a file about starts.
inline constexpr long most_parts = 10'000'000;

/// Collisions of a body in its corner: more are not followed.
inline constexpr long most_in_corner = 10'000;

}  // namespace dumbbell
