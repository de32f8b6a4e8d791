#pragma once

#include <optional>
#include <string_view>

#include "collisions/certificate.hpp"

/// The words of the file format (format.md) for scenes, sections, charts, axes and leaves.
namespace dumbbell::collisions {

[[nodiscard]] std::string_view name(Scene scene);

/// What people call it.
[[nodiscard]] std::string_view name(Section section);

/// The words after `lemmas` and `section`: `plain` is spelled as a set of lemmas of `full`.
struct SectionWords {
    std::string_view lemmas, section;

    friend bool operator==(const SectionWords&, const SectionWords&) = default;
};
[[nodiscard]] SectionWords spelled(Section section);

[[nodiscard]] std::string_view name(Chart chart);
[[nodiscard]] std::string_view axis_name(Chart chart, Axis axis);

/// The word of a leaf, which is also its kind in the totals.
[[nodiscard]] std::string_view name(Reason reason);

/// What a piece proves, as reports say it.
[[nodiscard]] std::string_view name(Status status);

/// Whether a leaf `count` of the chart has two counts: of the ray and of the reversed incoming ray. The full
/// section counts forward only.
[[nodiscard]] bool counts_both_ways(Chart chart);

/// The other way round; nothing for an unknown word.
[[nodiscard]] std::optional<Scene> scene_named(std::string_view word);
[[nodiscard]] std::optional<Section> section_named(std::string_view word);
[[nodiscard]] std::optional<Section> section_spelled(const SectionWords& words);
[[nodiscard]] std::optional<Axis> axis_named(Chart chart, std::string_view word);
[[nodiscard]] std::optional<Reason> reason_named(std::string_view word);

}  // namespace dumbbell::collisions
