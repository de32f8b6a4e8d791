#pragma once

#include <optional>
#include <string_view>

#include "collisions/certificate.hpp"

/// The words of the file format (format.md) for scenes, sections, charts, axes and leaves.
namespace dumbbell::collisions {

[[nodiscard]] std::string_view name(Scene scene);

/// The words after `section` and `lemmas`.
[[nodiscard]] std::string_view name(Section section);
[[nodiscard]] std::string_view lemma_set(Section section);

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
[[nodiscard]] std::optional<Section> section_named(std::string_view word, std::string_view lemmas);
[[nodiscard]] std::optional<Axis> axis_named(Chart chart, std::string_view word);
[[nodiscard]] std::optional<Reason> reason_named(std::string_view word);

}  // namespace dumbbell::collisions
