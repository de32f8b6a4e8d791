#include "collisions/orbit_text.hpp"

#include <fmt/core.h>

#include "words/printed.hpp"

namespace dumbbell::collisions {

using Orbit = std::vector<flight::Collision<Interval>>;

std::string collisions_text(const Orbit& orbit) {
    std::string text =
        fmt::format("{:>4} {:5} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24}\n", "#", "mass", "time",
                    "phi", "y", "ydot before", "ydot after", "phidot before", "phidot after");
    long number = 0;
    for (const auto& c : orbit) {
        text += fmt::format("{:>4} {:5} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24}\n", ++number,
                            c.heavy ? "heavy" : "light", enclosure_text(c.time), enclosure_text(c.phi),
                            enclosure_text(c.y), enclosure_text(c.ydot_before), enclosure_text(c.ydot_after),
                            enclosure_text(c.phidot_before), enclosure_text(c.phidot_after));
    }
    return text;
}

Json collisions_json(const Orbit& orbit) {
    Json collisions = Json::array();
    for (const auto& c : orbit) {
        collisions.add(Json::object({{"mass", c.heavy ? "heavy" : "light"},
                                     {"time", ends_json(c.time)},
                                     {"phi", ends_json(c.phi)},
                                     {"y", ends_json(c.y)},
                                     {"ydot_before", ends_json(c.ydot_before)},
                                     {"ydot_after", ends_json(c.ydot_after)},
                                     {"phidot_before", ends_json(c.phidot_before)},
                                     {"phidot_after", ends_json(c.phidot_after)},
                                     {"grazing_sine", ends_json(c.grazing_sine)}}));
    }
    return collisions;
}

}  // namespace dumbbell::collisions
