#include "pictures/orbit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "collisions/witness_orbit.hpp"
#include "number/decimal.hpp"
#include "pictures/frame.hpp"
#include "pictures/label_places.hpp"
#include "pictures/palette.hpp"
#include "pictures/snapshots.hpp"
#include "words/printed.hpp"

namespace dumbbell::pictures {
namespace {

using Orbit = std::vector<flight::Collision<Interval>>;
using std::numbers::pi;

constexpr double orbit_left = 76;
constexpr double orbit_height = 330;
constexpr double detail_height = 190;
constexpr double below_axes = 66;
constexpr double out_of_sight = 50;  // above a frame

/// The floor in the plane: h(psi) beta2 (theory: psi in one cell, [-pi, pi]).
struct Floor {
    double r;
    double beta2;

    explicit Floor(const Rational& q) : r(1 / q.convert_to<double>()), beta2(1 / (1 + r)) {}
};

struct Place {
    double psi, y;
};

Place place_of(const flight::Collision<Interval>& c) {
    return {approximate(c.phi) - pi / 2, approximate(c.y)};
}

/// The polyline with what lies far above the frame moved to a line just above it, where it is not seen: a
/// detail is stretched so much that programs that draw would lose the rest among their digits.
std::vector<Pixel> cut_above(const std::vector<Pixel>& points, const Frame& frame) {
    const double limit = frame.top() - out_of_sight;
    std::vector<Pixel> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Pixel& here = points[i];
        if (i > 0 && (points[i - 1].y < limit) != (here.y < limit)) {
            const Pixel& before = points[i - 1];
            const double share = (limit - before.y) / (here.y - before.y);
            result.push_back({before.x + (here.x - before.x) * share, limit});
        }
        result.push_back({here.x, std::max(here.y, limit)});
    }
    return result;
}

std::string path_text(const std::vector<Pixel>& points) {
    std::string path;
    for (const Pixel& p : points) {
        path += fmt::format("{}{} {}", path.empty() ? 'M' : 'L', px(p.x), px(p.y));
    }
    return path;
}

/// A curve over [from, to] as a path.
template <class Function>
std::string curve(const Frame& frame, double from, double to, const Function& height) {
    constexpr int parts = 64;
    std::vector<Pixel> points;
    for (int i = 0; i <= parts; ++i) {
        const double psi = from + (to - from) * i / parts;
        points.push_back({frame.x(psi), frame.y(height(psi))});
    }
    return path_text(cut_above(points, frame));
}

void draw_floor(Svg& svg, const Frame& frame, const Floor& floor) {
    const auto light = [&](double psi) { return -floor.beta2 * std::cos(psi); };
    const auto bridge = [&](double psi) { return floor.r * floor.beta2 * std::cos(psi); };
    const auto ground = [&](double psi) { return std::max(light(psi), bridge(psi)); };
    svg.path("ground",
             fmt::format("{}V{}H{}z", curve(frame, -pi, pi, ground), px(frame.bottom()), px(frame.left())));
    svg.path("light-wall", curve(frame, -pi, -pi / 2, light));
    svg.path("light-wall", curve(frame, pi / 2, pi, light));
    svg.path("bridge", curve(frame, -pi / 2, pi / 2, bridge));
}

/// Which flights are drawn: flight i ends with collision i (0: the one that comes in). All of a few; of many
/// those at the ends, those at the turn, and one in every few between.
class ShownFlights {
  public:
    explicit ShownFlights(const Orbit& orbit)
        : flights_(orbit.size() + 1),
          turn_(turn_of(orbit)),
          every_((flights_ + most_whole - 1) / most_whole) {}

    [[nodiscard]] std::size_t every() const { return every_; }
    [[nodiscard]] bool has(std::size_t flight) const {
        constexpr std::size_t at_ends = 3;
        constexpr std::size_t at_turn = 4;
        const bool is_near_turn = flight + at_turn > turn_ && flight <= turn_ + at_turn;
        return flight % every_ == 0 || flight < at_ends || flight + at_ends >= flights_ || is_near_turn;
    }
    /// Is it the end of a flight that is drawn?
    [[nodiscard]] bool has_collision(std::size_t i) const { return has(i) || has(i + 1); }
    /// Of many only the turn, the last, and the first one of flights that are drawn one after the other.
    [[nodiscard]] bool is_numbered(std::size_t i) const {
        return every_ == 1 || i == turn_ || i + 2 == flights_ || (has_collision(i) && (i == 0 || !has(i)));
    }

  private:
    static constexpr std::size_t most_whole = 40;
    std::size_t flights_;
    std::size_t turn_;
    std::size_t every_;
};

/// The orbit in pixels: a far point of the flight that comes in, the collisions, a far point of the one that
/// leaves.
std::vector<Pixel> path_of(const Frame& frame, const Orbit& orbit) {
    const auto pixel = [&](const Place& p) { return Pixel{frame.x(p.psi), frame.y(p.y)}; };
    const auto beyond = [&](const flight::Collision<Interval>& c, const Interval& phidot,
                            const Interval& ydot, double way) {
        const Place at = place_of(c);
        constexpr double far = 10;  // more than the frame is wide
        const double time = way * far / std::hypot(approximate(phidot), approximate(ydot));
        return pixel({at.psi + time * approximate(phidot), at.y + time * approximate(ydot)});
    };
    std::vector<Pixel> path{
        beyond(orbit.front(), orbit.front().phidot_before, orbit.front().ydot_before, -1)};
    for (const auto& c : orbit) {
        path.push_back(pixel(place_of(c)));
    }
    path.push_back(beyond(orbit.back(), orbit.back().phidot_after, orbit.back().ydot_after, 1));
    return path;
}

/// The flights that are drawn, those without a gap between them as one line.
std::string flights_text(const Frame& frame, const std::vector<Pixel>& path, const ShownFlights& shown) {
    std::string text;
    for (std::size_t i = 0; i + 1 < path.size();) {
        std::vector<Pixel> run;
        for (; i + 1 < path.size() && shown.has(i); ++i) {
            if (run.empty()) {
                run.push_back(path[i]);
            }
            run.push_back(path[i + 1]);
        }
        text += path_text(cut_above(run, frame));
        i += run.empty() ? 1 : 0;
    }
    return text;
}

/// An arrow head on the way from `from` to `to`, `away` from `near`, which is one of them.
void draw_arrow(Svg& svg, const Pixel& from, const Pixel& to, const Pixel& near) {
    constexpr double length = 10;
    constexpr double away = 45;
    constexpr double half = 4;
    const double distance = std::hypot(to.x - from.x, to.y - from.y);
    const double dx = (to.x - from.x) / distance;
    const double dy = (to.y - from.y) / distance;
    const double ahead = near.x == from.x && near.y == from.y ? away + length : -away;
    const Pixel tip{near.x + ahead * dx, near.y + ahead * dy};
    const Pixel end{tip.x - length * dx, tip.y - length * dy};
    svg.path("arrow", fmt::format("M{} {}L{} {}L{} {}z", px(tip.x), px(tip.y), px(end.x - half * dy),
                                  px(end.y + half * dx), px(end.x + half * dy), px(end.y - half * dx)));
}

void draw_collision(Svg& svg, bool heavy, const Pixel& at) {
    constexpr double radius = 4.5;
    if (heavy) {
        svg.rect("heavy", at.x - radius, at.y - radius, 2 * radius, 2 * radius);
    } else {
        svg.circle("light", at.x, at.y, radius);
    }
}

/// The numbers of the collisions that lie in the frame above `from`; of many only some.
void draw_numbers(Svg& svg, const Frame& frame, const Orbit& orbit, const std::vector<Pixel>& path,
                  double from) {
    constexpr double bold = 1.25;  // wider than other text, with its halo
    const ShownFlights shown(orbit);
    std::vector<Pixel> points;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        const Pixel& at = path[i + 1];
        if (at.y >= frame.top() && place_of(orbit[i]).y >= from && shown.is_numbered(i)) {
            points.push_back(at);
            numbers.push_back(i + 1);
        }
    }
    const double widest = bold * text_width(fmt::format("{}", orbit.size()));
    const auto places =
        label_places(points, path, widest, {frame.left(), frame.top(), frame.right(), frame.bottom()});
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (places[i]) {
            svg.text(places[i]->x, places[i]->y + 4.5, fmt::format("{}", numbers[i]), Anchor::middle,
                     "number");
        }
    }
}

void draw_panel(Svg& svg, const Frame& frame, const Floor& floor, const Orbit& orbit, double numbers_from) {
    const std::vector<Pixel> path = path_of(frame, orbit);
    const ShownFlights shown(orbit);
    frame.draw_grid(svg);
    frame.open_clip(svg);
    draw_floor(svg, frame, floor);
    svg.path("flight", flights_text(frame, path, shown));
    if (path[1].y >= frame.top()) {
        draw_arrow(svg, path.front(), path[1], path[1]);
    }
    if (path[path.size() - 2].y >= frame.top()) {
        draw_arrow(svg, path[path.size() - 2], path.back(), path[path.size() - 2]);
    }
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        if (shown.has_collision(i) && path[i + 1].y >= frame.top() - out_of_sight) {
            draw_collision(svg, orbit[i].heavy, path[i + 1]);
        }
    }
    draw_numbers(svg, frame, orbit, path, numbers_from);
    svg.close();
    frame.draw_axes(svg);
}

Frame frame_of(double frame_top, double height, double y_hi, int wanted) {
    return {orbit_left,
            frame_top,
            page_width - orbit_left - right_margin,
            height,
            {-pi, pi, "psi = phi \xe2\x88\x92 \xcf\x80/2 (radians)", angle_ticks(-pi, pi)},
            {0, y_hi, "y (rod lengths)", even_ticks(0, y_hi, wanted)}};
}

void orbit_style(Svg& svg) {
    svg.rules(
        ".light-wall,.bridge{fill:none;stroke-width:2.5}.flight{fill:none;stroke-width:1.2;stroke-linejoin:"
        "round}"
        ".number{font-weight:600;paint-order:stroke;stroke-width:3;stroke-linejoin:round}");
    svg.colour("ground", "fill", palette::floor);
    svg.colour("light-wall", "stroke", palette::light);
    svg.colour("light", "fill", palette::light);
    svg.colour("bridge", "stroke", palette::heavy);
    svg.colour("heavy", "fill", palette::heavy);
    svg.colour("flight", "stroke", {"#3b434c", "#b9c2cb"});
    svg.colour("arrow", "fill", {"#3b434c", "#b9c2cb"});
    svg.colour("number", "stroke", {"#fff", "#12161c"});
}

std::string caption_of(const Orbit& orbit, const Rational& q, bool has_detail) {
    double widest = 0;
    for (const auto& c : orbit) {
        widest = std::max({widest, width(c.phi), width(c.y)});
    }
    const ShownFlights shown(orbit);
    return fmt::format(
        "q = {}: an orbit with {} collisions, each one enclosed and proved; psi and y are drawn at the "
        "middle of their enclosures, which are at most {} wide. Between collisions the point flies straight; "
        "the floor is where the light mass (outside) or the heavy mass (the bridge in the middle) "
        "touches.{}{}{}",
        exact_text(q), orbit.size(), rounded_up(widest),
        has_detail ? " The second picture is the first, cut off just above the bridge and stretched." : "",
        shown.every() == 1 ? ""
                           : fmt::format(" Not all flights are drawn, but the first, the last, those at "
                                         "the turn, and one in {} between.",
                                         shown.every()),
        shown_collisions(orbit).size() < orbit.size()
            ? " The strip shows the dumbbell at the first collisions, around the turn, and at the last."
            : "");
}

}  // namespace

std::string orbit_svg(const collisions::Piece& piece, const Rational& q) {
    if (!piece.witness) {
        throw InputError(fmt::format("there is no orbit at the mass ratio {} to draw", exact_text(q)));
    }
    if (piece.witness->total() > Count(most_drawn_collisions)) {
        throw InputError(fmt::format("a picture shows {} collisions at most, and this orbit has {}",
                                     most_drawn_collisions, piece.witness->total()));
    }
    const Orbit orbit = witness_orbit(*piece.witness, q, piece.bits);
    if (orbit.empty()) {
        throw InputError(fmt::format("the orbit cannot be enclosed with {} bits", piece.bits));
    }
    return orbit_svg(orbit, q);
}

std::string orbit_svg(const Orbit& orbit, const Rational& q) {
    const Floor floor(q);
    constexpr double low_bridge = 0.1;  // of the humps' height
    constexpr double detail_of_bridge = 6.5;
    constexpr double above_humps = 1.25;
    const bool has_detail = floor.r < low_bridge;
    const double detail = detail_of_bridge * floor.r * floor.beta2;

    const Legend legend({{Swatch::dot, "light", "the light mass hits the floor"},
                         {Swatch::square, "heavy", "the heavy mass hits the floor"},
                         {Swatch::curve, "flight", "flight"}},
                        page_width - orbit_left - right_margin);
    const Frame whole =
        frame_of(top_margin + legend.height() + 10, orbit_height, above_humps * floor.beta2, 6);
    const Frame near = frame_of(whole.bottom() + below_axes, detail_height, detail, 4);
    const double snapshots_top = (has_detail ? near : whole).bottom() + below_axes;
    const double caption_top = snapshots_top + snapshots_height() + 4;
    const auto caption = broken_lines(caption_of(orbit, q, has_detail), whole.width());

    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "An orbit of a bouncing dumbbell with its collisions");
    orbit_style(svg);
    legend.draw(svg, orbit_left, top_margin);
    draw_panel(svg, whole, floor, orbit, has_detail ? detail : 0);
    if (has_detail) {
        draw_panel(svg, near, floor, orbit, 0);
    }
    draw_snapshots(svg, orbit, q, orbit_left, snapshots_top, whole.width());
    draw_caption(svg, orbit_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
