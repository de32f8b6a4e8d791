#include "pictures/box_panel.hpp"

#include <fmt/core.h>

namespace dumbbell::pictures {

void style_boxes(Svg& svg, std::size_t boxes) {
    constexpr std::size_t many = 3000;  // their outlines would hide their colours
    svg.rules(boxes > many ? ".box{stroke-width:.2}" : ".box{stroke-width:.6}");
    svg.colour("box", "stroke", {"#2b3138", "#0b0e12"});
}

void draw_boxes(Svg& svg, const Frame& frame, const DrawnBoxes& boxes) {
    for (const auto& [kind, of_kind] : boxes) {
        std::string path;
        for (const DrawnBox& box : of_kind) {
            const std::string left = px(frame.x(box.x_lo));
            path += fmt::format("M{} {}H{}V{}H{}z", left, px(frame.y(box.y_lo)), px(frame.x(box.x_hi)),
                                px(frame.y(box.y_hi)), left);
        }
        svg.path(fmt::format("box {}", kind), path);
    }
}

}  // namespace dumbbell::pictures
