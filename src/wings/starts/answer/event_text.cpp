#include "starts/answer/event_text.hpp"

#include <fmt/core.h>

#include <array>

#include "number/decimal.hpp"

namespace dumbbell::starts {
namespace {

struct Words {
    const char* name;  ///< in JSON
    const char* kind;
    const char* near;  ///< what something is on or near to
};

/// Of each Obstacle.
constexpr std::array<Words, obstacles> words{
    {{"flat", "flat fall", "a flat fall, a contact of both masses at once"},
     {"corner", "corner", "a corner, a contact of both masses at once"},
     {"graze", "grazing contact", "a grazing contact"},
     {"corner_or_graze", "corner or grazing contact",
      "a corner, a contact of both masses at once, or a grazing contact"},
     {"other", "too wide to tell", ""}}};

const Words& words_of(Obstacle obstacle) { return words.at(static_cast<std::size_t>(obstacle)); }

}  // namespace

std::string event_text(Obstacle obstacle) { return words_of(obstacle).near; }

std::string kinds_text(const Subdivision& parts) {
    std::string text;
    const auto add = [&](const char* word, long boxes) {
        if (boxes > 0) {
            text += fmt::format("{} {} {}",
                                text.empty() ? "Undecided boxes by what they are on or near to:" : ",", word,
                                boxes);
        }
    };
    for (std::size_t i = 0; i < obstacles; ++i) {
        add(words.at(i).kind, parts.near.at(i));
    }
    add("not looked at", parts.unexplained);
    return text.empty() ? "" : text + "\n";
}

Json kinds_json(const Subdivision& parts) {
    Json kinds = Json::object();
    for (std::size_t i = 0; i < obstacles; ++i) {
        kinds.add(words.at(i).name, parts.near.at(i));
    }
    kinds.add("not_looked_at", parts.unexplained);
    return kinds;
}

std::string corner_text(const ExactEvent& event) {
    return fmt::format("{}both masses reach the floor at once{} (a corner, where no motion is defined)",
                       event.kind == Obstacle::flat ? "the rod falls flat: " : "",
                       event.time ? ", at time " + exact_text(*event.time) : "");
}

Json event_json(const std::optional<ExactEvent>& event, const std::optional<Obstacle>& obstacle,
                std::size_t collisions) {
    const bool none_collides = event && event->kind == Obstacle::graze;
    return Json::object({{"kind", words_of(event ? event->kind : *obstacle).name},
                         {"certain", event.has_value()},
                         {"collision", none_collides ? Json() : Json(collisions + 1)},
                         {"time", event && event->time ? Json(to_fraction(*event->time)) : Json()}});
}

}  // namespace dumbbell::starts
