#include "report/staircase_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "arith/error.hpp"
#include "model/growth_constant.hpp"
#include "model/paper_bound.hpp"
#include "report/plot_frame.hpp"

namespace dumbbell {
namespace {

constexpr double left = 64;
constexpr double plot_height = 380;

double value(const Rational& q) { return q.convert_to<double>(); }

/// ceil(pi / gamma) + 1 steps from m to m + 1 behind q = cot^2(pi / 2m).
std::string paper_path(const Frame& frame, const Rational& q_lo, const Rational& q_hi) {
    long bound = paper_bound(q_lo);
    const long last = paper_bound(q_hi);
    std::string path =
        fmt::format("M{:.2f} {:.2f}", frame.x(value(q_lo)), frame.y(static_cast<double>(bound)));
    for (; bound < last; ++bound) {
        const double t = std::tan(std::numbers::pi / (2 * static_cast<double>(bound - 1)));
        fmt::format_to(std::back_inserter(path), "H{:.2f}V{:.2f}", frame.x(1 / (t * t)),
                       frame.y(static_cast<double>(bound + 1)));
    }
    return path + fmt::format("H{:.2f}", frame.x(value(q_hi)));
}

/// 2 + C sqrt q, which the maximum stays close to (theorem 4).
std::string growth_path(const Frame& frame, double q_lo, double q_hi) {
    const double c = approximate(growth_constant());
    std::string path;
    constexpr int parts = 200;
    for (int i = 0; i <= parts; ++i) {
        const double q = q_lo * std::pow(q_hi / q_lo, static_cast<double>(i) / parts);
        fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', frame.x(q),
                       frame.y(2 + c * std::sqrt(q)));
    }
    return path;
}

/// The proved values: exact pieces as treads, gaps as risers at their middle.
std::string proved_path(const Frame& frame, const std::vector<Piece>& pieces) {
    std::string path;
    bool pen_down = false;
    for (const Piece& piece : pieces) {
        if (piece.status() == Status::open) {
            pen_down = false;
            continue;
        }
        if (piece.status() == Status::gap) {
            continue;
        }
        const double y = frame.y(static_cast<double>(*piece.upper));
        const double x = frame.x(value(piece.q_lo));
        path += pen_down ? fmt::format("H{:.2f}V{:.2f}", x, y) : fmt::format("M{:.2f} {:.2f}", x, y);
        path += fmt::format("H{:.2f}", frame.x(value(piece.q_hi)));
        pen_down = true;
    }
    return path;
}

/// From 0 while that shows every step; many counts by their logarithm, on which the square root is a line.
PlotAxis count_axis(double most) {
    constexpr double many = 20;
    constexpr int wanted = 8;
    return most <= many
               ? PlotAxis{0, most * 1.04, "collisions",
                          even_ticks(0, most * 1.04, std::min(wanted, static_cast<int>(most)))}
               : PlotAxis{1.5, most * 1.2, "collisions", decade_ticks(1.5, most * 1.2), Scale::logarithmic};
}

/// What the picture is called, and its line in the legend.
struct Names {
    const char* title;
    const char* maximum;
};

Names names_of(Scene scene) {
    switch (scene) {
        case Scene::dumbbell:
            return {"Greatest number of collisions of a bouncing dumbbell against its mass ratio",
                    "proved maximum N(q)"};
        case Scene::hybrid:
            return {"Greatest number of collisions in the hybrid wedge against the mass ratio",
                    "proved maximum, scene hybrid (wedge)"};
        case Scene::wedge:
            return {"Greatest number of collisions in the straight wedge against the mass ratio",
                    "proved maximum, scene wedge (straight)"};
    }
    throw BrokenInvariant("unknown scene");
}

/// The greatest count that the picture shows.
long greatest_count(const std::vector<Piece>& pieces, Scene scene) {
    if (scene == Scene::dumbbell) {
        return paper_bound(pieces.back().q_hi);
    }
    long greatest = 2;
    for (const Piece& piece : pieces) {
        greatest = std::max(greatest, piece.upper.value_or(0));
    }
    return greatest;
}

}  // namespace

std::string staircase_svg(const std::vector<Piece>& pieces, Scene scene) {
    require(!pieces.empty() && pieces.front().q_lo < pieces.back().q_hi, "staircase picture: an empty range");
    const Rational& q_lo = pieces.front().q_lo;
    const Rational& q_hi = pieces.back().q_hi;
    const Names names = names_of(scene);
    std::vector<LegendEntry> entries{{Swatch::curve, "proved", names.maximum}};
    if (scene == Scene::dumbbell) {  // the bound and the growth are the dumbbell's
        entries.push_back({Swatch::curve, "paper", "the paper's bound ceil(\xcf\x80/\xce\xb3)+1"});
        entries.push_back({Swatch::curve, "growth", "2 + C \xe2\x88\x9aq"});
    }
    const auto is_open = [](const Piece& piece) { return piece.status() == Status::open; };
    if (std::any_of(pieces.begin(), pieces.end(), is_open)) {
        entries.push_back({Swatch::area, "hatched", "not decided"});
    }
    const Legend legend(std::move(entries), page_width - left - right_margin);
    const double frame_top = top_margin + legend.height() + 10;
    const Frame frame(left, frame_top, page_width - left - right_margin, plot_height,
                      {value(q_lo), value(q_hi), "mass ratio q (heavy over light)",
                       decade_ticks(value(q_lo), value(q_hi)), Scale::logarithmic},
                      count_axis(static_cast<double>(greatest_count(pieces, scene))));

    Svg svg(page_width, frame.bottom() + 52, names.title);
    svg.rules(
        ".proved{fill:none;stroke-width:2.5}.paper{fill:none;stroke-width:1.5;stroke-dasharray:6 4}"
        ".growth{fill:none;stroke-width:1.2;stroke-dasharray:2 3}");
    svg.colour("proved", "stroke", {"#0055a4", "#63adff"});
    svg.colour("paper", "stroke", {"#c8501e", "#ff9466"});
    svg.colour("growth", "stroke", {"#111", "#fff"});
    for (const Piece& piece : pieces) {
        if (is_open(piece)) {
            const double x = frame.x(value(piece.q_lo));
            svg.rect("hatched", x, frame.top(), frame.x(value(piece.q_hi)) - x, frame.height());
        }
    }
    frame.draw_grid(svg);
    if (scene == Scene::dumbbell) {
        svg.path("paper", paper_path(frame, q_lo, q_hi));
    }
    svg.path("proved", proved_path(frame, pieces));
    if (scene == Scene::dumbbell) {
        svg.path("growth", growth_path(frame, value(q_lo), value(q_hi)));  // over it: they lie close together
    }
    frame.draw_axes(svg);
    legend.draw(svg, left, top_margin);
    return svg.finished();
}

}  // namespace dumbbell
