#include "pictures/count_colours.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pictures/palette.hpp"

namespace dumbbell::pictures {
namespace {

struct Colour {
    double red, green, blue;
};

/// Viridis at equal steps, bright to dark.
constexpr std::array<Colour, 10> colour_scale{{{253, 231, 37},
                                               {181, 222, 43},
                                               {110, 206, 88},
                                               {53, 183, 121},
                                               {31, 158, 137},
                                               {38, 130, 142},
                                               {49, 104, 142},
                                               {62, 73, 137},
                                               {72, 40, 120},
                                               {68, 1, 84}}};

/// Of the scale: 1 is its beginning, 4 its middle, and no count its end.
const double half_way = 3;

/// The share of the scale that stands out from a dark page.
constexpr double share_on_dark = 0.84;

/// t in [0, 1].
std::string colour_at(double t) {
    const double at = t * static_cast<double>(colour_scale.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), colour_scale.size() - 2);
    const double part = at - static_cast<double>(i);
    const auto mixed = [&](double Colour::*channel) {
        return std::lround(colour_scale[i].*channel +
                           (colour_scale[i + 1].*channel - colour_scale[i].*channel) * part);
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(&Colour::red), mixed(&Colour::green),
                       mixed(&Colour::blue));
}

}  // namespace

std::string count_kind(const Count& count) { return fmt::format("n{}", count); }

std::map<Count, CountShade> count_shades(const std::vector<Count>& counts) {
    std::map<Count, CountShade> shades;
    for (const Count& count : counts) {
        const auto steps = static_cast<double>(count - 1);
        const double t = steps / (steps + half_way);
        shades[count] = count == 0 ? CountShade{std::string(palette::no_collision.light),
                                                std::string(palette::no_collision.dark)}
                                   : CountShade{colour_at(t), colour_at(t * share_on_dark)};
    }
    return shades;
}

void colour_counts(Svg& svg, const std::vector<Count>& counts) {
    for (const auto& [count, colour] : count_shades(counts)) {
        svg.colour(count_kind(count), "fill", colour.shade());
    }
}

std::vector<Count> shown_counts(const std::vector<Count>& counts) {
    constexpr std::size_t most = 13;
    if (counts.size() <= most) {
        return counts;
    }
    std::vector<Count> shown(most);
    for (std::size_t i = 0; i < most; ++i) {
        shown[i] = counts[i * (counts.size() - 1) / (most - 1)];
    }
    return shown;
}

}  // namespace dumbbell::pictures
