#include "pictures/label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dumbbell::pictures {
namespace {

constexpr double number_height = 14;
constexpr double point_radius = 6;
constexpr int directions = 16;
constexpr double too_much = 1000;  // hidden by another number, or outside
constexpr std::array<double, 3> distances{14, 20, 27};

double distance_to_segment(const Pixel& p, const Pixel& a, const Pixel& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// How much a number at `place` hides.
double hidden(const Pixel& place, const std::vector<Pixel>& placed, const std::vector<Pixel>& points,
              const std::vector<Pixel>& path, double number_width, const PixelRange& range) {
    constexpr double point_cost = 10;
    constexpr double path_cost = 1;
    double cost = 0;
    if (place.x - number_width / 2 < range.left || place.x + number_width / 2 > range.right ||
        place.y - number_height / 2 < range.top || place.y + number_height / 2 > range.bottom) {
        cost += too_much;
    }
    for (const Pixel& other : placed) {
        if (std::abs(other.x - place.x) < number_width && std::abs(other.y - place.y) < number_height) {
            cost += too_much;
        }
    }
    for (const Pixel& point : points) {
        if (std::abs(point.x - place.x) < number_width / 2 + point_radius &&
            std::abs(point.y - place.y) < number_height / 2 + point_radius) {
            cost += point_cost;
        }
    }
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (distance_to_segment(place, path[i - 1], path[i]) < number_height / 2) {
            cost += path_cost;
        }
    }
    return cost;
}

}  // namespace

std::vector<std::optional<Pixel>> label_places(const std::vector<Pixel>& points,
                                               const std::vector<Pixel>& path, double width,
                                               const PixelRange& range) {
    constexpr double farther_cost = 0.3;
    std::vector<Pixel> placed;
    std::vector<std::optional<Pixel>> places;
    for (const Pixel& point : points) {
        Pixel best{};
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t ring = 0; ring < distances.size(); ++ring) {
            for (int i = 0; i < directions; ++i) {
                const double angle = std::numbers::pi * (0.5 + 2.0 * i / directions);  // from above, round
                const Pixel place{point.x + distances[ring] * std::cos(angle),
                                  point.y - distances[ring] * std::sin(angle)};
                const double cost = hidden(place, placed, points, path, width, range) +
                                    farther_cost * static_cast<double>(ring);
                if (cost < least) {
                    least = cost;
                    best = place;
                }
            }
        }
        if (least < too_much) {
            placed.push_back(best);
            places.emplace_back(best);
        } else {
            places.emplace_back();
        }
    }
    return places;
}

}  // namespace dumbbell::pictures
