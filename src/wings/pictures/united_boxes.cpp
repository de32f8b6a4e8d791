#include "pictures/united_boxes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"

namespace dumbbell::pictures {
namespace {

/// The places on one axis in ascending order. A union of boxes depends on the order of their ends alone, so
/// it is found with the places' numbers, whatever the depth of the boxes.
std::vector<Rational> places(const std::vector<PlaneBox>& boxes, std::size_t axis) {
    std::vector<Rational> values;
    for (const PlaneBox& box : boxes) {
        values.push_back(box.lo[axis]);
        values.push_back(box.hi[axis]);
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

int number_in(const std::vector<Rational>& places, const Rational& value) {
    return static_cast<int>(std::ranges::lower_bound(places, value) - places.begin());
}

using Vertex = std::array<int, 2>;
/// Along the axis, in its direction or against it.
struct Heading {
    std::size_t axis;
    int sign;
    bool operator==(const Heading&) const = default;
};
Heading left_of(Heading h) { return h.axis == 0 ? Heading{1, h.sign} : Heading{0, -h.sign}; }

/// The edges of all boxes, counterclockwise: where two boxes touch their edges cancel each other, and the
/// boundary of the union is left, with the union on its left.
class Boundary {
  public:
    void add(Vertex lo, Vertex hi) {
        for (const std::size_t axis : {0U, 1U}) {
            const std::size_t across = 1 - axis;
            const int forward = axis == 0 ? 1 : -1;  // the lower side along x, and the upper side along y
            change(axis, lo[across], lo[axis], hi[axis], forward);
            change(axis, hi[across], lo[axis], hi[axis], -forward);
        }
    }

    /// The edges from vertex to vertex, at each vertex by their heading. Throws BrokenInvariant if boxes
    /// overlap along an edge.
    [[nodiscard]] std::map<Vertex, std::vector<std::pair<Heading, Vertex>>> edges() const {
        std::map<Vertex, std::vector<std::pair<Heading, Vertex>>> result;
        for (const std::size_t axis : {0U, 1U}) {
            for (const auto& [line, changes] : lines_[axis]) {
                int direction = 0;
                int from = 0;
                for (const auto& [place, change] : changes) {
                    if (direction != 0) {
                        const Vertex low = axis == 0 ? Vertex{from, line} : Vertex{line, from};
                        const Vertex high = axis == 0 ? Vertex{place, line} : Vertex{line, place};
                        const Heading heading{axis, direction};
                        result[direction > 0 ? low : high].emplace_back(heading, direction > 0 ? high : low);
                    }
                    direction += change;
                    from = place;
                }
            }
        }
        return result;
    }

  private:
    void change(std::size_t axis, int line, int from, int to, int by) {
        lines_[axis][line][from] += by;
        lines_[axis][line][to] -= by;
    }

    /// Of each axis and each line along it: where the number of edges, with their directions, changes, and by
    /// how much.
    std::array<std::map<int, std::map<int, int>>, 2> lines_;
};

/// Throws BrokenInvariant if two boxes overlap: a line that sweeps over them from the left meets those that
/// it cuts in intervals that have no inner point in common.
void require_disjoint(std::vector<std::pair<Vertex, Vertex>> boxes) {
    std::multimap<int, Vertex> ends;  // the boxes that the line cuts, by their right sides
    std::map<int, int> cut;           // their lower sides and their upper ones
    std::sort(boxes.begin(), boxes.end());
    for (const auto& [lo, hi] : boxes) {
        while (!ends.empty() && ends.begin()->first <= lo[0]) {
            cut.erase(ends.begin()->second[1]);
            ends.erase(ends.begin());
        }
        const auto above = cut.lower_bound(lo[1]);
        const bool free = (above == cut.end() || above->first >= hi[1]) &&
                          (above == cut.begin() || std::prev(above)->second <= lo[1]);
        require(free, "boxes to be united overlap");
        cut.emplace(lo[1], hi[1]);
        ends.emplace(hi[0], lo);
    }
}

/// Positive if the curve goes round counterclockwise (outer boundaries), negative for holes.
Rational signed_area(const Outline& outline) {
    Rational twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint& a = outline[i];
        const PlanePoint& b = outline[(i + 1) % outline.size()];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return twice / 2;
}

}  // namespace

std::vector<Outline> united(const std::vector<PlaneBox>& boxes) {
    const auto x = places(boxes, 0);
    const auto y = places(boxes, 1);
    Boundary boundary;
    std::vector<std::pair<Vertex, Vertex>> numbered;
    Rational missing = 0;
    for (const PlaneBox& box : boxes) {
        const auto& [lo, hi] =
            numbered.emplace_back(Vertex{number_in(x, box.lo[0]), number_in(y, box.lo[1])},
                                  Vertex{number_in(x, box.hi[0]), number_in(y, box.hi[1])});
        boundary.add(lo, hi);
        missing += (box.hi[0] - box.lo[0]) * (box.hi[1] - box.lo[1]);
    }

    require_disjoint(std::move(numbered));

    std::vector<Outline> outlines;
    auto edges = boundary.edges();
    while (!edges.empty()) {
        // The first vertex is the lowest of those furthest to the left: a corner that no other curve touches.
        const Vertex start = edges.begin()->first;
        Vertex at = start;
        Outline curve;
        std::optional<Heading> heading;
        do {
            // Where boxes touch in a corner only two edges lead on: the one to the right makes one curve of
            // both.
            auto& ways = edges.at(at);
            const bool second = ways.size() == 2 && ways[0].first == left_of(*heading);
            const auto [next, to] = ways[second ? 1 : 0];
            if (heading != next) {
                curve.push_back({x[static_cast<std::size_t>(at[0])], y[static_cast<std::size_t>(at[1])]});
            }
            ways.erase(ways.begin() + (second ? 1 : 0));
            if (ways.empty()) {
                edges.erase(at);
            }
            heading = next;
            at = to;
        } while (at != start);
        outlines.push_back(std::move(curve));
    }
    for (const Outline& curve : outlines) {
        missing -= signed_area(curve);
    }
    require(missing == 0, "the outlines of united boxes do not have their area");
    for (Outline& curve : outlines) {
        std::rotate(curve.begin(), std::min_element(curve.begin(), curve.end()), curve.end());
    }
    std::sort(outlines.begin(), outlines.end());
    return outlines;
}

std::string path_of(const std::vector<Outline>& outlines,
                    const std::function<std::array<long, 2>(const PlanePoint&)>& place) {
    std::string path;
    for (const Outline& outline : outlines) {
        auto [x, y] = place(outline.front());
        path += fmt::format("M{} {}", x, y);
        for (auto point = std::next(outline.begin()); point != outline.end(); ++point) {
            const auto [next_x, next_y] = place(*point);
            if (next_x != x) {
                path += fmt::format("h{}", next_x - x);
            }
            if (next_y != y) {
                path += fmt::format("v{}", next_y - y);
            }
            x = next_x;
            y = next_y;
        }
        path += 'z';
    }
    return path;
}

}  // namespace dumbbell::pictures
