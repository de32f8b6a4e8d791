#pragma once

#include <optional>
#include <vector>

namespace dumbbell::pictures {

struct Pixel {
    double x, y;
};

struct PixelRange {
    double left, top, right, bottom;
};

/// Where numbers of this width stand next to points, so that they do not cover one another nor, as far as
/// there is room, the points and the path through them: for each point the middle of its number, or nothing
/// where it would cover another number or leave the range. In the order of the points, each where it hides
/// least; deterministic.
[[nodiscard]] std::vector<std::optional<Pixel>> label_places(const std::vector<Pixel>& points,
                                                             const std::vector<Pixel>& path, double width,
                                                             const PixelRange& range);

}  // namespace dumbbell::pictures
