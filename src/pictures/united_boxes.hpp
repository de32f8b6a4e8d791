#pragma once

#include <vector>

#include "pictures/plane_box.hpp"

namespace dumbbell {

/// A closed curve of horizontal and vertical edges in turns; the last vertex is joined to the first.
using Outline = std::vector<PlanePoint>;

/// The outlines of the union of boxes whose interiors are pairwise disjoint: outer boundaries and holes, to
/// be filled by the even-odd rule; exactly. Throws BrokenInvariant unless they enclose exactly the
/// area that the boxes have together.
[[nodiscard]] std::vector<Outline> united(const std::vector<PlaneBox>& boxes);

}  // namespace dumbbell
