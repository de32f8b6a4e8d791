#include "collisions/section.hpp"

#include <algorithm>
#include <array>

namespace dumbbell::collisions {
namespace {

/// In the order of Section.
constexpr std::array section_rows{&turning_row, &full_row, &plain_row, &body_row, &plain_body_row};

template <class Fits>
std::optional<Section> first_section(Fits fits) {
    const auto* const found = std::ranges::find_if(section_rows, fits);
    return found == section_rows.end() ? std::nullopt
                                       : std::optional(static_cast<Section>(found - section_rows.begin()));
}

}  // namespace

const SectionRow& row_of(Section section) { return *section_rows.at(static_cast<std::size_t>(section)); }

const SectionRow& staircase_of(const System& system) {
    return system.rho && *system.rho == 1 ? symmetric_row : row_of(system.section);
}

std::optional<Section> section_named(std::string_view scene, std::string_view section) {
    return first_section(
        [&](const SectionRow* row) { return row->scene == scene && row->section == section; });
}

std::optional<Section> section_in_file(std::string_view scene, std::string_view lemmas,
                                       std::string_view section) {
    return first_section([&](const SectionRow* row) {
        return row->scene == scene && row->lemmas == lemmas && row->section_in_file == section;
    });
}

}  // namespace dumbbell::collisions
