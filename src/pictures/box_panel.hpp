#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pictures/frame.hpp"

namespace dumbbell::pictures {

/// A box in the coordinates of a frame.
struct DrawnBox {
    double x_lo, x_hi, y_lo, y_hi;
};

/// Boxes by the class of their colour.
using DrawnBoxes = std::map<std::string, std::vector<DrawnBox>>;

/// The styles of their outlines, which are the thinner the more boxes there are.
void style_boxes(Svg& svg, std::size_t boxes);

/// Draws them into the frame, one path for each class.
void draw_boxes(Svg& svg, const Frame& frame, const DrawnBoxes& boxes);

}  // namespace dumbbell::pictures
