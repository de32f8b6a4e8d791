#include "collisions/orbit_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "words/printed.hpp"

namespace dumbbell::collisions {

using flight::Collision;

namespace {

using Orbit = std::vector<Collision<Interval>>;

struct Column {
    const char* name;
    Interval Collision<Interval>::*member;
};

constexpr std::array<Column, 4> width_columns{{{"phi", &Collision<Interval>::phi},
                                               {"y", &Collision<Interval>::y},
                                               {"ydot after", &Collision<Interval>::ydot_after},
                                               {"phidot after", &Collision<Interval>::phidot_after}}};

std::string width_text(const Interval& x) { return x.lo() == x.hi() ? "0" : rounded_up(width(x)); }

}  // namespace

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

std::string widths_text(const Orbit& orbit) {
    std::string text = fmt::format("{:>8}", "#");
    for (const Column& column : width_columns) {
        text += fmt::format(" {:>12}", column.name);
    }
    text += '\n';
    const auto line = [&](std::size_t number) {
        text += fmt::format("{:>8}", number);
        for (const Column& column : width_columns) {
            text += fmt::format(" {:>12}", width_text(orbit[number - 1].*column.member));
        }
        text += '\n';
    };
    for (std::size_t number = 1; number < orbit.size(); number *= 10) {
        line(number);
    }
    line(orbit.size());
    text += fmt::format("{:>8}", "widest");
    for (const Column& column : width_columns) {
        const auto widest = std::max_element(orbit.begin(), orbit.end(), [&](const auto& a, const auto& b) {
            return width(a.*column.member) < width(b.*column.member);
        });
        text += fmt::format(" {:>12}", width_text((*widest).*column.member));
    }
    return text + '\n';
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
