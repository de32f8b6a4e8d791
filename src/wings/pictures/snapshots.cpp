#include "pictures/snapshots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace dumbbell::pictures {
namespace {

constexpr std::size_t most_snapshots = 14;
constexpr std::size_t at_ends = 3;      // of more
constexpr std::size_t beside_turn = 2;  // on each side
constexpr double rod = 44;              // pixels
constexpr double above_rod = 12;        // room for a mass
constexpr double below_rod = 26;        // for the number
constexpr double light_radius = 3.5;
constexpr double most_times = 2;

/// Larger the heavier, but never so large that a disc hides the rod.
double heavy_radius(const Rational& q) {
    constexpr double power = 0.28;
    return light_radius * std::min(most_times, std::pow(q.convert_to<double>(), power));
}

}  // namespace

std::size_t turn_of(const std::vector<flight::Collision<Interval>>& orbit) {
    const auto heavy = std::find_if(orbit.begin(), orbit.end(), [](const auto& c) { return c.heavy; });
    const auto lowest = std::min_element(orbit.begin(), orbit.end(), [](const auto& a, const auto& b) {
        return approximate(a.y) < approximate(b.y);
    });
    return static_cast<std::size_t>((heavy != orbit.end() ? heavy : lowest) - orbit.begin());
}

std::vector<std::size_t> shown_collisions(const std::vector<flight::Collision<Interval>>& orbit) {
    const std::size_t turn = turn_of(orbit);
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        const bool is_near_turn = i + beside_turn >= turn && i <= turn + beside_turn;
        if (orbit.size() <= most_snapshots || i < at_ends || i + at_ends >= orbit.size() || is_near_turn) {
            shown.push_back(i);
        }
    }
    return shown;
}

double snapshots_height() { return above_rod + rod + below_rod + 20; }

void draw_snapshots(Svg& svg, const std::vector<flight::Collision<Interval>>& orbit, const Rational& q,
                    double left, double top, double width) {
    const std::vector<std::size_t> shown = shown_collisions(orbit);
    std::size_t slots = shown.size();
    for (std::size_t i = 1; i < shown.size(); ++i) {
        slots += shown[i] > shown[i - 1] + 1 ? 1 : 0;
    }
    const double beta2 = 1 / (1 + 1 / q.convert_to<double>());
    const double beta1 = 1 - beta2;
    const double step = width / static_cast<double>(slots);
    const double floor = top + above_rod + rod;
    svg.line("frame", left, floor, left + width, floor);
    double middle = left - step / 2;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        middle += step;
        if (i > 0 && shown[i] > shown[i - 1] + 1) {
            svg.text(middle, floor - rod / 2, "\xe2\x80\xa6", Anchor::middle);
            middle += step;
        }
        const double phi = approximate(orbit[shown[i]].phi);
        const double y = approximate(orbit[shown[i]].y);
        const double shift =
            (beta2 - beta1) / 2 * std::cos(phi);  // the rod's own middle, not its centre of mass
        const double light_x = middle + rod * (beta2 * std::cos(phi) - shift);
        const double heavy_x = middle - rod * (beta1 * std::cos(phi) + shift);
        const double light_y = floor - rod * (y + beta2 * std::sin(phi));
        const double heavy_y = floor - rod * (y - beta1 * std::sin(phi));
        svg.line("flight", light_x, light_y, heavy_x, heavy_y);
        svg.circle("heavy", heavy_x, heavy_y, heavy_radius(q));
        svg.circle("light", light_x, light_y, light_radius);
        svg.text(middle, floor + below_rod, fmt::format("{}", shown[i] + 1), Anchor::middle, "number");
    }
}

}  // namespace dumbbell::pictures
