#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "pictures/plane_box.hpp"

namespace dumbbell::pictures {

/// A closed curve of horizontal and vertical edges in turns; the last vertex is joined to the first.
using Outline = std::vector<PlanePoint>;

/// The outlines of the union of boxes: outer boundaries and holes, to be filled by the even-odd rule;
/// exactly. Throws BrokenInvariant if boxes overlap.
[[nodiscard]] std::vector<Outline> united(const std::vector<PlaneBox>& boxes);

/// Their path, with every vertex at its place.
[[nodiscard]] std::string path_of(const std::vector<Outline>& outlines,
                                  const std::function<std::array<long, 2>(const PlanePoint&)>& place);

}  // namespace dumbbell::pictures
