#pragma once

#include <optional>
#include <vector>

namespace dumbbell {

struct Pixel {
    double x, y;
};

struct PixelRange {
    double left, top, right, bottom;
};

/// Where numbers stand beside points, so that they cover neither one another nor, as far as there is room,
/// the points and the path through them: for each point the middle of its number. In the order of the points,
/// each where it hides least; deterministic.
[[nodiscard]] std::vector<std::optional<Pixel>> label_places(const std::vector<Pixel>& points,
                                                             const std::vector<Pixel>& path,
                                                             const PixelRange& range);

}  // namespace dumbbell
