#pragma once

#include <optional>
#include <string_view>

#include "base/named.hpp"
#include "collisions/certificate.hpp"

/// The words of the file format (format.md) for scenes, sections, charts, axes and leaves. Each is a switch
/// without default (base/named.hpp).
namespace dumbbell::collisions {

[[nodiscard]] constexpr std::string_view name(Scene scene) {
    switch (scene) {
        case Scene::dumbbell:
            return "dumbbell";
        case Scene::hybrid:
            return "hybrid";
        case Scene::wedge:
            return "wedge";
        case Scene::body:
            return "body";
    }
    return {};
}

/// What people call it.
[[nodiscard]] constexpr std::string_view name(Section section) {
    switch (section) {
        case Section::turning:
            return "turning";
        case Section::full:
            return "full";
        case Section::plain:
            return "plain";
    }
    return {};
}

/// The word of a leaf, which is also its kind in the totals.
[[nodiscard]] constexpr std::string_view name(Reason reason) {
    switch (reason) {
        case Reason::count:
            return "count";
        case Reason::outside:
            return "outside";
        case Reason::meets:
            return "meets";
        case Reason::meets_reversed:
            return "meets-reversed";
        case Reason::once:
            return "once";
    }
    return {};
}

/// What a piece proves, as reports say it.
[[nodiscard]] constexpr std::string_view name(Status status) {
    switch (status) {
        case Status::exact:
            return "exact";
        case Status::gap:
            return "gap";
        case Status::open:
            return "open";
    }
    return {};
}

/// The cover of one line of symmetric bodies (L72).
inline constexpr std::string_view symmetric_word = "symmetric";

struct ChartNames {
    std::string_view chart, position, slope;
    /// Whether a leaf `count` has two counts: of the ray and of the reversed incoming ray. The full section
    /// counts forward only.
    bool both_ways = true;
};

[[nodiscard]] constexpr ChartNames names_of(Chart chart) {
    switch (chart) {
        case Chart::bridge:
            return {"bridge", "e", "eta"};
        case Chart::light:
            return {"light", "e", "lambda"};
        case Chart::contact:
        case Chart::plain_contact:
            return {"contact", "t", "eta", false};
        case Chart::departure:
        case Chart::plain_departure:
            return {"departure", "e", "eta", false};
        case Chart::again:
            return {"again", "t", "eta"};
        case Chart::wedge:
            return {"wedge", "e", "lambda"};
        case Chart::corner:
            return {"corner", "e", "eta"};
    }
    return {};
}

[[nodiscard]] constexpr std::string_view name(Chart chart) { return names_of(chart).chart; }
[[nodiscard]] constexpr bool counts_both_ways(Chart chart) { return names_of(chart).both_ways; }

[[nodiscard]] constexpr std::string_view axis_name(Chart chart, Axis axis) {
    const ChartNames names = names_of(chart);
    switch (axis) {
        case Axis::position:
            return names.position;
        case Axis::slope:
            return names.slope;
        case Axis::ratio:
            return "q";
        case Axis::rho:
            return "rho";
    }
    return {};
}

/// The other way round; nothing for an unknown word.
[[nodiscard]] constexpr std::optional<Axis> axis_named(Chart chart, std::string_view word) {
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio, Axis::rho}) {
        if (word == axis_name(chart, axis)) {
            return axis;
        }
    }
    return std::nullopt;
}

/// The words after `lemmas` and `section`: `plain` is spelled as a set of lemmas of `full`, one of its own
/// for bodies.
struct SectionWords {
    std::string_view lemmas, section;

    friend bool operator==(const SectionWords&, const SectionWords&) = default;
};
[[nodiscard]] constexpr SectionWords spelled(Section section, Scene scene) {
    if (section == Section::plain) {
        return {scene == Scene::body ? "body" : "minimal", "full"};
    }
    return {"1", name(section)};
}
[[nodiscard]] constexpr std::optional<Section> section_spelled(const SectionWords& words, Scene scene) {
    for (int i = 0; !name(static_cast<Section>(i)).empty(); ++i) {
        if (words == spelled(static_cast<Section>(i), scene)) {
            return static_cast<Section>(i);
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
