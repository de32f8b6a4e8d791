#include "starts/event_words.hpp"

#include <fmt/core.h>

#include <array>

#include "number/decimal.hpp"

namespace dumbbell::starts {
namespace {

const char* name(ExactKind kind) {
    return kind == ExactKind::flat ? "flat" : kind == ExactKind::corner ? "corner" : "graze";
}

}  // namespace

const char* name(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::flat:
            return "flat";
        case Obstacle::corner:
            return "corner";
        case Obstacle::graze:
            return "graze";
        case Obstacle::corner_or_graze:
            return "corner_or_graze";
        case Obstacle::other:
            break;
    }
    return "other";
}

std::string event_words(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::flat:
            return "a fall flat, a contact of both masses at once";
        case Obstacle::corner:
            return "a corner, a contact of both masses at once";
        case Obstacle::graze:
            return "a grazing contact";
        case Obstacle::corner_or_graze:
            return "a corner, a contact of both masses at once, or a grazing contact";
        case Obstacle::other:
            break;
    }
    return "";
}

std::string kinds_text(const Subdivision& parts) {
    constexpr std::array<const char*, obstacles> words{"fall flat", "corner", "grazing contact",
                                                       "corner or grazing contact", "neither"};
    std::string text;
    const auto add = [&](const char* word, long boxes) {
        if (boxes > 0) {
            text += fmt::format("{} {} {}",
                                text.empty() ? "Undecided boxes by what they are on or near to:" : ",", word,
                                boxes);
        }
    };
    for (std::size_t i = 0; i < obstacles; ++i) {
        add(words.at(i), parts.near.at(i));
    }
    add("not looked at", parts.unexplained);
    return text.empty() ? "" : text + "\n";
}

Json kinds_json(const Subdivision& parts) {
    Json kinds = Json::object();
    for (std::size_t i = 0; i < obstacles; ++i) {
        kinds.add(name(static_cast<Obstacle>(i)), parts.near.at(i));
    }
    kinds.add("not_looked_at", parts.unexplained);
    return kinds;
}

std::string corner_words(const ExactEvent& event) {
    return fmt::format("{}both masses reach the floor at once{} (a corner, where no motion is defined)",
                       event.kind == ExactKind::flat ? "the rod falls flat: " : "",
                       event.time ? ", at time " + exact_text(*event.time) : "");
}

Json event_json(const std::optional<ExactEvent>& event, const std::optional<Obstacle>& obstacle,
                std::size_t collisions) {
    const bool none_collides = event && event->kind == ExactKind::graze;
    return Json::object({{"kind", event ? name(event->kind) : name(*obstacle)},
                         {"certain", event.has_value()},
                         {"collision", none_collides ? Json() : Json(collisions + 1)},
                         {"time", event && event->time ? Json(to_fraction(*event->time)) : Json()}});
}

}  // namespace dumbbell::starts
