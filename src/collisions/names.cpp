#include "collisions/names.hpp"

namespace dumbbell::collisions {

std::optional<Axis> axis_named(Chart chart, std::string_view word) {
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio}) {
        if (word == axis_name(chart, axis)) {
            return axis;
        }
    }
    return std::nullopt;
}

SectionWords spelled(Section section) {
    return section == Section::plain ? SectionWords{"minimal", "full"} : SectionWords{"1", name(section)};
}

std::optional<Section> section_spelled(const SectionWords& words) {
    for (int i = 0; !name(static_cast<Section>(i)).empty(); ++i) {
        if (words == spelled(static_cast<Section>(i))) {
            return static_cast<Section>(i);
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
