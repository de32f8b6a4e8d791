#include "collisions/names.hpp"

#include "base/named.hpp"

namespace dumbbell::collisions {
namespace {

constexpr std::array<Named<Scene>, 3> scenes{
    {{Scene::dumbbell, "dumbbell"}, {Scene::hybrid, "hybrid"}, {Scene::wedge, "wedge"}}};

constexpr std::array<Named<Section>, 3> sections{
    {{Section::turning, "turning"}, {Section::full, "full"}, {Section::plain, "plain"}}};

constexpr std::array<Named<Chart>, 8> chart_names{{{Chart::bridge, "bridge"},
                                                   {Chart::light, "light"},
                                                   {Chart::contact, "contact"},
                                                   {Chart::plain_contact, "contact"},
                                                   {Chart::departure, "departure"},
                                                   {Chart::plain_departure, "departure"},
                                                   {Chart::again, "again"},
                                                   {Chart::wedge, "wedge"}}};

constexpr std::array<Named<Reason>, 5> reasons{{{Reason::count, "count"},
                                                {Reason::outside, "outside"},
                                                {Reason::meets, "meets"},
                                                {Reason::meets_reversed, "meets-reversed"},
                                                {Reason::once, "once"}}};

constexpr std::array<Named<Status>, 3> states{
    {{Status::exact, "exact"}, {Status::gap, "gap"}, {Status::open, "open"}}};

}  // namespace

std::string_view name(Scene scene) { return name_in(scenes, scene); }

std::string_view name(Section section) { return name_in(sections, section); }

SectionWords spelled(Section section) {
    return section == Section::plain ? SectionWords{"minimal", "full"} : SectionWords{"1", name(section)};
}

std::string_view name(Chart chart) { return name_in(chart_names, chart); }

std::string_view axis_name(Chart chart, Axis axis) {
    const bool is_contact = chart == Chart::contact || chart == Chart::plain_contact || chart == Chart::again;
    const bool has_lambda = chart == Chart::light || chart == Chart::wedge;
    switch (axis) {
        case Axis::position:
            return is_contact ? "t" : "e";
        case Axis::slope:
            return has_lambda ? "lambda" : "eta";
        default:
            return "q";
    }
}

std::string_view name(Reason reason) { return name_in(reasons, reason); }

std::string_view name(Status status) { return name_in(states, status); }

bool counts_both_ways(Chart chart) { return name(chart) != "contact" && name(chart) != "departure"; }

std::optional<Scene> scene_named(std::string_view word) { return value_named(scenes, word); }

std::optional<Section> section_named(std::string_view word) { return value_named(sections, word); }

std::optional<Section> section_spelled(const SectionWords& words) {
    for (const auto& [section, word] : sections) {
        if (words == spelled(section)) {
            return section;
        }
    }
    return std::nullopt;
}

std::optional<Axis> axis_named(Chart chart, std::string_view word) {
    for (const Axis axis : {Axis::position, Axis::slope, Axis::ratio}) {
        if (word == axis_name(chart, axis)) {
            return axis;
        }
    }
    return std::nullopt;
}

std::optional<Reason> reason_named(std::string_view word) { return value_named(reasons, word); }

}  // namespace dumbbell::collisions
