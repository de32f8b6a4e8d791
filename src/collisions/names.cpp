#include "collisions/names.hpp"

namespace dumbbell::collisions {

std::string_view name(Scene scene) {
    switch (scene) {
        case Scene::hybrid:
            return "hybrid";
        case Scene::wedge:
            return "wedge";
        default:
            return "dumbbell";
    }
}

std::string_view name(Section section) { return section == Section::turning ? "turning" : "full"; }

std::string_view lemma_set(Section section) { return section == Section::plain ? "minimal" : "1"; }

std::string_view name(Chart chart) {
    switch (chart) {
        case Chart::bridge:
            return "bridge";
        case Chart::light:
            return "light";
        case Chart::contact:
        case Chart::plain_contact:
            return "contact";
        case Chart::departure:
        case Chart::plain_departure:
            return "departure";
        case Chart::again:
            return "again";
        default:
            return "wedge";
    }
}

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

std::string_view name(Reason reason) {
    switch (reason) {
        case Reason::count:
            return "count";
        case Reason::outside:
            return "outside";
        case Reason::meets:
            return "meets";
        case Reason::meets_reversed:
            return "meets-reversed";
        default:
            return "once";
    }
}

std::string_view name(Status status) {
    switch (status) {
        case Status::exact:
            return "exact";
        case Status::gap:
            return "gap";
        default:
            return "open";
    }
}

bool counts_both_ways(Chart chart) { return name(chart) != "contact" && name(chart) != "departure"; }

std::optional<Scene> scene_named(std::string_view word) {
    for (const Scene scene : {Scene::dumbbell, Scene::hybrid, Scene::wedge}) {
        if (word == name(scene)) {
            return scene;
        }
    }
    return std::nullopt;
}

std::optional<Section> section_named(std::string_view word, std::string_view lemmas) {
    for (const Section section : {Section::turning, Section::full, Section::plain}) {
        if (word == name(section) && lemmas == lemma_set(section)) {
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

std::optional<Reason> reason_named(std::string_view word) {
    for (const Reason reason :
         {Reason::count, Reason::outside, Reason::meets, Reason::meets_reversed, Reason::once}) {
        if (word == name(reason)) {
            return reason;
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
