#include "report/snapshots.hpp"

#include <fmt/format.h>

#include <cmath>

namespace dumbbell {
namespace {

constexpr std::size_t most_snapshots = 14;
constexpr double rod = 44;    // pixels
constexpr double above = 12;  // room for a mass
constexpr double below = 26;  // for the number
constexpr double light_radius = 3.5;
constexpr double heavy_radius = 7;

}  // namespace

double snapshots_height(const std::vector<Collision<Interval>>& orbit) {
    return orbit.size() > most_snapshots ? 0 : above + rod + below + 20;
}

void draw_snapshots(Svg& svg, const std::vector<Collision<Interval>>& orbit, const Rational& q, double left,
                    double top, double width) {
    if (orbit.size() > most_snapshots) {
        return;
    }
    const double beta2 = 1 / (1 + 1 / q.convert_to<double>());
    const double beta1 = 1 - beta2;
    const double step = width / static_cast<double>(orbit.size());
    const double floor = top + above + rod;
    svg.line("frame", left, floor, left + width, floor);
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        const double phi = approximate(orbit[i].phi);
        const double y = approximate(orbit[i].y);
        const double middle = left + (static_cast<double>(i) + 0.5) * step;
        const double shift =
            (beta2 - beta1) / 2 * std::cos(phi);  // the rod's own middle, not its centre of mass
        const double light_x = middle + rod * (beta2 * std::cos(phi) - shift);
        const double heavy_x = middle - rod * (beta1 * std::cos(phi) + shift);
        const double light_y = floor - rod * (y + beta2 * std::sin(phi));
        const double heavy_y = floor - rod * (y - beta1 * std::sin(phi));
        svg.line("flight", light_x, light_y, heavy_x, heavy_y);
        svg.circle("heavy", heavy_x, heavy_y, heavy_radius);
        svg.circle("light", light_x, light_y, light_radius);
        svg.text(middle, floor + below, fmt::format("{}", i + 1), Anchor::middle, "number");
    }
}

}  // namespace dumbbell
