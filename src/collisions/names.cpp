#include "collisions/names.hpp"

#include "base/words_for.hpp"

namespace dumbbell::collisions {
namespace {

constexpr std::array<Word<Scene>, 3> scenes{
    {{Scene::dumbbell, "dumbbell"}, {Scene::hybrid, "hybrid"}, {Scene::wedge, "wedge"}}};

constexpr std::array<Word<Section>, 3> sections{
    {{Section::turning, "turning"}, {Section::full, "full"}, {Section::plain, "plain"}}};

constexpr std::array<Word<Chart>, 8> chart_names{{{Chart::bridge, "bridge"},
                                                  {Chart::light, "light"},
                                                  {Chart::contact, "contact"},
                                                  {Chart::plain_contact, "contact"},
                                                  {Chart::departure, "departure"},
                                                  {Chart::plain_departure, "departure"},
                                                  {Chart::again, "again"},
                                                  {Chart::wedge, "wedge"}}};

constexpr std::array<Word<Reason>, 5> reasons{{{Reason::count, "count"},
                                               {Reason::outside, "outside"},
                                               {Reason::meets, "meets"},
                                               {Reason::meets_reversed, "meets-reversed"},
                                               {Reason::once, "once"}}};

constexpr std::array<Word<Status>, 3> states{
    {{Status::exact, "exact"}, {Status::gap, "gap"}, {Status::open, "open"}}};

}  // namespace

std::string_view name(Scene scene) { return word_for(scenes, scene); }

std::string_view name(Section section) { return word_for(sections, section); }

SectionWords spelled(Section section) {
    return section == Section::plain ? SectionWords{"minimal", "full"} : SectionWords{"1", name(section)};
}

std::string_view name(Chart chart) { return word_for(chart_names, chart); }

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

std::string_view name(Reason reason) { return word_for(reasons, reason); }

std::string_view name(Status status) { return word_for(states, status); }

bool counts_both_ways(Chart chart) { return name(chart) != "contact" && name(chart) != "departure"; }

std::optional<Scene> scene_named(std::string_view word) { return meaning_of(scenes, word); }

std::optional<Section> section_named(std::string_view word) { return meaning_of(sections, word); }

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

std::optional<Reason> reason_named(std::string_view word) { return meaning_of(reasons, word); }

}  // namespace dumbbell::collisions
