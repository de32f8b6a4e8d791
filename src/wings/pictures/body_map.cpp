#include "pictures/body_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "collisions/claim.hpp"
#include "flight/corner.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/frame.hpp"
#include "pictures/label_places.hpp"
#include "pictures/palette.hpp"
#include "pictures/united_boxes.hpp"

namespace dumbbell::pictures {

using collisions::Cell;

namespace {

constexpr double map_left = 64;
constexpr double map_width = 684;  // the bodies at rho = 1 are named beside it
constexpr double map_height = 560;

constexpr int last_bright = 5;  // black can be read on its colour (count_colours.hpp); beyond, white
constexpr Shade ink{"#1d2430", "#12161c"};  ///< on bright colours, on dark pages, too
constexpr Shade beyond_edge{"#e8eaed", "#4a535d"};

/// rho and the inertia of two ends of the mass ratio q and a uniform rod of mu times their mass.
std::pair<double, double> rod_body(double q, double mu) {
    const auto claim = claim_of(collisions::Rod{exact(q), exact(mu)});
    return {value(*claim.system.rho), value(claim.range.lo)};
}

Frame frame_of(const std::vector<Cell>& cells) {
    double least = 0.01, lo = 1, hi = 100;
    for (const auto& [bodies, lower, upper] : cells) {
        least = std::min(least, value(bodies.rho.lo));
        lo = std::min(lo, value(bodies.q.lo));
        hi = std::max(hi, value(bodies.q.hi));
    }
    return {map_left,
            top_margin + 24,
            map_width,
            map_height,
            PlotAxis{least, 1, "rho = d2/d1 (logarithmic)", decade_ticks(least, 1, {map_width}),
                     Scale::logarithmic},
            PlotAxis{lo, hi, "Q = (d1/k)\xc2\xb2 (logarithmic)", decade_ticks(lo, hi, {map_height, true}),
                     Scale::logarithmic}};
}

PixelRange place_of(const Frame& frame, const Cell& cell) {
    const auto& [rho, q] = cell.bodies;
    return {frame.x(value(rho.lo)), frame.y(value(q.hi)), frame.x(value(rho.hi)), frame.y(value(q.lo))};
}

/// The class of a cell with more than one value. Where ceil(pi/corner) is above the least one, so is N (L73).
std::string step_kind(const Cell& cell) {
    constexpr long most = 10'000;  // no more are proved of a corner
    const long least = std::clamp(as_long(cell.lower), 1L, most);
    return !cell.upper                                                                 ? "hatched"
           : flight::corner_count(cell.bodies.rho.hi, cell.bodies.q.hi, least) > least ? "corner-step"
                                                                                       : "orbit-step";
}

/// Each number covers the lesser ones, so that no ground shows between two; then the steps.
void draw_areas(Svg& svg, const Frame& frame, const std::vector<Cell>& cells,
                const std::vector<Count>& counts) {
    std::map<std::string, std::vector<PlaneBox>> areas;
    for (const Cell& cell : cells) {
        const auto& [rho, q] = cell.bodies;
        const PlaneBox box{{rho.lo, q.lo}, {rho.hi, q.hi}};
        for (const Count& count : counts) {
            if (count <= cell.lower) {
                areas[count_kind(count)].push_back(box);
            }
        }
        if (!cell.is_exact()) {
            areas[step_kind(cell)].push_back(box);
        }
    }
    constexpr double units = 10;  // to a pixel
    const auto draw = [&](const std::string& kind) {
        svg.path(kind, path_of(united(areas[kind]), [&](const PlanePoint& point) {
                     return std::array{std::lround(units * frame.x(value(point[0]))),
                                       std::lround(units * frame.y(value(point[1])))};
                 }));
    };
    svg.open_units(0, 0, 1 / units, 1 / units);
    std::ranges::for_each(counts, draw, count_kind);
    for (const char* kind : {"hatched", "orbit-step", "corner-step"}) {
        draw(kind);
    }
    svg.close();
}

/// Rods of growing mass; the points of their curves.
std::vector<Pixel> draw_rods(Svg& svg, const Frame& frame) {
    std::vector<Pixel> points;
    for (const double q : {10.0, 100.0}) {
        svg.path("rods", frame.curve([&](double share) {
            const auto body = rod_body(q, share == 0 ? 0 : std::pow(10, 8 * share - 4));
            points.push_back({frame.x(body.first), frame.y(body.second)});
            return body;
        }));
        for (const double mass : {0.01, 0.1, 1.0, 10.0}) {
            const auto [rho, inertia] = rod_body(q, mass);
            svg.circle("rod", frame.x(rho), frame.y(inertia), 3);
        }
    }
    return points;
}

double distance(const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Names all areas: inside their greatest cells, off the curves, and again far from there; or beside the
/// frame.
void draw_numbers(Svg& svg, const Frame& frame, const std::vector<Cell>& cells,
                  const std::vector<Pixel>& curves) {
    struct Room {
        PixelRange of;
        Count count;
        [[nodiscard]] double size() const { return std::min(of.right - of.left, of.bottom - of.top); }
    };
    constexpr double least = 4, roomy = 30, height = 11, far = 150;
    std::vector<Room> rooms;
    std::map<Count, PixelRange> sides;
    for (const Cell& cell : cells) {
        if (cell.is_exact()) {
            const PixelRange place = rooms.emplace_back(place_of(frame, cell), cell.lower).of;
            if (cell.bodies.rho.hi == 1) {
                PixelRange& side = sides.try_emplace(cell.lower, place).first->second;
                side.top = std::min(side.top, place.top);
                side.bottom = std::max(side.bottom, place.bottom);
            }
        }
    }
    std::ranges::stable_sort(rooms, std::greater(), &Room::size);
    std::vector<std::pair<Count, Pixel>> names;
    const auto is_free = [&](const Count& count, const Pixel& at) {
        return std::ranges::none_of(
            names, [&](const auto& name) { return name.first == count && distance(name.second, at) < far; });
    };
    const auto is_inside = [&](const Count& count, double x, double y) {
        return std::ranges::any_of(rooms, [&](const Room& room) {
            return room.count == count && room.of.left <= x && x <= room.of.right && room.of.top <= y &&
                   y <= room.of.bottom;
        });
    };
    const auto has_room = [&](const Count& count, const Pixel& at) {
        const double x = text_width(fmt::format("{}", count)) / 2 + 2, y = height / 2;
        return is_inside(count, at.x - x, at.y - y) && is_inside(count, at.x + x, at.y - y) &&
               is_inside(count, at.x - x, at.y + y) && is_inside(count, at.x + x, at.y + y) &&
               std::ranges::all_of(curves, [&](const Pixel& on) { return distance(on, at) > height; });
    };
    const auto name = [&](const Count& count, const Pixel& at, double lower, std::string_view kind) {
        names.emplace_back(count, at);
        svg.text(at.x, at.y + lower, fmt::format("{}", count), Anchor::middle, kind);
    };
    for (const Room& room : rooms) {
        const Pixel at{(room.of.left + room.of.right) / 2, (room.of.top + room.of.bottom) / 2};
        if (room.size() >= least && is_free(room.count, at) && has_room(room.count, at)) {
            name(room.count, at, room.size() > roomy ? 7 : 4.5,
                 fmt::format("number{}{}", room.size() > roomy ? " roomy" : "",
                             room.count > last_bright ? " on-dark" : ""));
        }
    }
    for (const auto& [count, side] : sides) {
        const Pixel at{frame.right() + 14, (side.top + side.bottom) / 2};
        if (side.bottom - side.top >= height && is_free(count, at)) {
            name(count, at, 4.5, "");
        }
    }
}

}  // namespace

std::string body_map_svg(const std::vector<Cell>& cells) {
    std::set<Count> found;
    for (const Cell& cell : cells) {
        if (cell.is_exact()) {
            found.insert(cell.lower);
        }
    }
    const std::vector<Count> counts(found.begin(), found.end());
    const Frame frame = frame_of(cells);
    const std::string title = "The greatest number of collisions N of every rigid body, in a plane";
    const auto caption = broken_lines(
        "Verified: all bodies in an area of one colour have this N. The steps are enclosed, not sampled: "
        "they lie "
        "in the cells that make the curves, drawn a pixel wider, or are hatched.",
        map_width);
    const double caption_top = frame.bottom() + 62;
    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()), title);
    svg.rules(
        ".beyond,.rod,.corner-step,.orbit-step{fill:currentColor}.massless,.rods,.body{fill:none;stroke-"
        "width:2}"
        ".massless,.rods,.body,.corner-step,.orbit-step{stroke:currentColor}"
        ".corner-step,.orbit-step{stroke-width:10}.thick{stroke-width:3}.rods{stroke-width:1.4;stroke-"
        "dasharray:5 3}"
        ".number{font-weight:600;fill:#111}.roomy{font-size:20px}.on-dark{fill:#fff}");
    for (const auto& [kind, shade] : {std::pair("corner-step", palette::paper),
                                      {"orbit-step", ink},
                                      {"massless", ink},
                                      {"rods", ink},
                                      {"rod", ink},
                                      {"body", palette::witness},
                                      {"beyond", beyond_edge}}) {
        svg.colour(kind, "color", shade);
    }
    colour_counts(svg, counts);
    svg.text(map_left, top_margin + 9, title, Anchor::start, "head");

    frame.open_clip(svg);
    const std::string edge = fmt::format("M{} {}L{} {}", px(frame.x(1e-9)), px(frame.y(1e9)),
                                         px(frame.right()), px(frame.y(1)));  // from outside
    svg.path("beyond", fmt::format("{}V{}H{}z", edge, px(frame.bottom()), px(map_left)));
    draw_areas(svg, frame, cells, counts);
    svg.path("massless", edge);
    svg.close();
    draw_numbers(svg, frame, cells, draw_rods(svg, frame));
    for (const auto& [inertia, name] :
         {std::pair(1.0, "equal masses"), {2.0, "ring"}, {3.0, "uniform rod"}, {4.0, "coin"}}) {
        svg.circle("body", frame.right(), frame.y(inertia), 6);
        svg.text(frame.right() + 12, frame.y(inertia) + 4, name);
    }
    frame.draw_axes(svg);
    const Legend legend(
        {{Swatch::curve, "corner-step thick", "steps of the corner: one more hit fits in"},
         {Swatch::curve, "orbit-step thick", "steps of orbits that go on over the bridge"},
         {Swatch::curve, "massless", "massless rods, Q rho = 1"},
         {Swatch::curve, "rods", "rods between ends of 10 : 1 and 100 : 1, their mass growing"},
         {Swatch::dot, "rod", "a rod of 1/100, 1/10, 1, 10 times the mass of its ends"},
         {Swatch::area, "hatched", "not decided"},
         {Swatch::area, "beyond", "mass beyond the contacts, Q rho < 1"}},
        1);
    legend.draw(svg, map_left + 14, frame.bottom() - legend.height() - 8);
    draw_caption(svg, map_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
