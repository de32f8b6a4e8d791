#include "pictures/staircase.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "flight/growth_constant.hpp"
#include "flight/paper_bound.hpp"
#include "pictures/frame.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::pictures {

using collisions::Piece;
using collisions::Status;

namespace {

constexpr double staircase_left = 64;
constexpr double staircase_height = 380;
constexpr const char* title = "Greatest number of collisions of a bouncing dumbbell against its mass ratio";

/// The paper's bound ceil(pi / gamma) + 1, which steps from m + 1 to m + 2 after q = cot^2(pi / 2m).
std::string paper_path(const Frame& frame, const std::vector<Piece>& pieces) {
    const Rational& q_lo = pieces.front().q_lo;
    const Rational& q_hi = pieces.back().q_hi;
    long m = flight::paper_bound(q_lo) - 1;
    const long last = flight::paper_bound(q_hi) - 1;
    const auto y = [&](long of) { return frame.y(static_cast<double>(of + 1)); };
    std::string path = fmt::format("M{:.2f} {:.2f}", frame.x(value(q_lo)), y(m));
    for (; m < last; ++m) {
        const double t = std::tan(std::numbers::pi / (2 * static_cast<double>(m)));
        path += fmt::format("H{:.2f}V{:.2f}", frame.x(1 / (t * t)), y(m + 1));
    }
    return path + fmt::format("H{:.2f}", frame.x(value(q_hi)));
}

/// 2 + C sqrt q, which the maximum stays close to (theorem 4).
std::string growth_path(const Frame& frame, double q_lo, double q_hi) {
    const double c = approximate(flight::growth_constant());
    return frame.curve([&](double share) {
        const double q = q_lo * std::pow(q_hi / q_lo, share);
        return std::pair(q, 2 + c * std::sqrt(q));
    });
}

auto with_status(const std::vector<Piece>& pieces, Status status) {
    return std::views::filter(pieces, [status](const Piece& piece) { return piece.status() == status; });
}

/// The proved values: a line over each piece with one value.
std::string proved_path(const Frame& frame, const std::vector<Piece>& pieces) {
    std::string path;
    for (const Piece& piece : with_status(pieces, Status::exact)) {
        path += fmt::format("M{:.2f} {:.2f}H{:.2f}", frame.x(value(piece.q_lo)),
                            frame.y(static_cast<double>(*piece.upper)), frame.x(value(piece.q_hi)));
    }
    return path;
}

/// The gaps: all that lies between their two values, for the value there is one of them.
std::string gap_path(const Frame& frame, const std::vector<Piece>& pieces) {
    std::string path;
    for (const Piece& piece : with_status(pieces, Status::gap)) {
        const double left_end = frame.x(value(piece.q_lo));
        path += fmt::format("M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}z", left_end,
                            frame.y(static_cast<double>(piece.lower)), frame.x(value(piece.q_hi)),
                            frame.y(static_cast<double>(*piece.upper)), left_end);
    }
    return path;
}

/// The counts that the vertical axis has to show.
struct Counts {
    long least;
    long most;
    bool has_paper;  ///< the paper's bound lies so near that it can be drawn, too
};

/// Counts from 0 on are evenly spaced up to here.
constexpr long many = 20;

Counts counts_of(const std::vector<Piece>& pieces) {
    long least = as_long(pieces.front().lower);
    long most = 2;
    for (const Piece& piece : pieces) {
        least = std::min(least, as_long(piece.lower));
        most = std::max({most, as_long(piece.lower), as_long(piece.upper.value_or(0))});
    }
    const long highest = flight::paper_bound(pieces.back().q_hi);
    constexpr long share = 4;  // of the axis, at least, that is left to the steps
    const bool has_paper = highest <= many || highest - least <= share * (most - least) + 8;
    return {least, has_paper ? highest : most, has_paper};
}

/// From 0 while that shows every step; counts that grow many times over by their logarithm, on which the
/// square root is a line; else the range that there is.
PlotAxis count_axis(const Counts& counts) {
    constexpr int wanted = 8;
    constexpr double growing = 3;
    const auto least = static_cast<double>(counts.least);
    const auto most = static_cast<double>(counts.most);
    if (counts.most <= many) {
        const double hi = most * 1.04;
        return {0, hi, "collisions", even_ticks(0, hi, std::min(wanted, static_cast<int>(std::ceil(hi))))};
    }
    if (most > growing * least) {
        const double hi = most * 1.2;
        return {1.5, hi, "collisions (logarithmic)", decade_ticks(1.5, hi, {staircase_height, true}),
                Scale::logarithmic};
    }
    const double lo = least - 1.5;
    const double hi = most + 1.5;
    return {lo, hi, "collisions", even_ticks(lo, hi, std::min(wanted, static_cast<int>(hi - lo)))};
}

/// Hatches the ranges of the pieces that are open.
void draw_open(Svg& svg, const Frame& frame, const std::vector<Piece>& pieces) {
    for (const Piece& piece : with_status(pieces, Status::open)) {
        const double x = frame.x(value(piece.q_lo));
        svg.rect("hatched", x, frame.top(), frame.x(value(piece.q_hi)) - x, frame.height());
    }
}

}  // namespace

std::string staircase_svg(const collisions::Certificate& certificate) {
    const std::vector<Piece>& pieces = certificate.pieces;
    require(!pieces.empty() && pieces.front().q_lo < pieces.back().q_hi, "staircase picture: an empty range");
    if (pieces.back().q_hi > flight::paper_bound_limit()) {
        throw InputError("no picture reaches beyond the mass ratio 3e31");
    }
    const double q_lo = value(pieces.front().q_lo);
    const double q_hi = value(pieces.back().q_hi);
    constexpr double narrowest = 1e-12;
    if (q_hi - q_lo < narrowest * q_hi) {
        throw InputError(
            "the range is too narrow for this picture: dumbbell report shows it, by its distance "
            "from the step");
    }
    const auto has = [&](Status status) { return !with_status(pieces, status).empty(); };
    const Counts counts = counts_of(pieces);
    std::vector<LegendEntry> entries{{Swatch::curve, "proved", "proved maximum N(q)"}};
    if (has(Status::gap)) {
        entries.push_back({Swatch::area, "gap", "gap: one of two values"});
    }
    if (has(Status::open)) {
        entries.push_back({Swatch::area, "hatched", "not decided"});
    }
    if (counts.has_paper) {
        entries.push_back(
            {Swatch::curve, "paper", "the paper's bound \xe2\x8c\x88\xcf\x80/\xce\xb3\xe2\x8c\x89 + 1"});
    }
    entries.push_back({Swatch::curve, "growth", "2 + C \xe2\x88\x9aq"});
    const double width = page_width - staircase_left - right_margin;
    const Legend legend(std::move(entries), width);
    const double legend_top = top_margin + 24;
    const Frame frame(staircase_left, legend_top + legend.height() + 10, width, staircase_height,
                      {q_lo, q_hi, "mass ratio q (heavy over light, logarithmic)",
                       decade_ticks(q_lo, q_hi, {width}), Scale::logarithmic},
                      count_axis(counts));

    Svg svg(page_width, frame.bottom() + 52, title);
    svg.rules(
        ".proved{fill:none;stroke-width:2.5}.gap{stroke-width:1.5}.paper{fill:none;stroke-width:1.5;stroke-"
        "dasharray:6 4}.growth{fill:none;stroke-width:1.2;stroke-dasharray:2 3}");
    svg.colour("proved", "stroke", palette::proved);
    svg.colour("gap", "fill", palette::gap);
    svg.colour("gap", "stroke", palette::gap);
    svg.colour("paper", "stroke", palette::paper);
    svg.colour("paper-word", "fill", palette::paper);
    svg.colour("growth", "stroke", palette::growth);
    svg.text(staircase_left, top_margin + 9, title, Anchor::start, "head");
    draw_open(svg, frame, pieces);
    frame.draw_grid(svg);
    frame.open_clip(svg);
    if (has(Status::gap)) {
        svg.path("gap", gap_path(frame, pieces));
    }
    if (counts.has_paper) {
        svg.path("paper", paper_path(frame, pieces));
    }
    svg.path("proved", proved_path(frame, pieces));
    svg.path("growth", growth_path(frame, q_lo, q_hi));  // over it: they lie close together
    svg.close();
    if (!counts.has_paper) {  // it lies too far above the maximum to be drawn
        const long lo = flight::paper_bound(pieces.front().q_lo),
                   hi = flight::paper_bound(pieces.back().q_hi);
        svg.text(frame.left() + 10, frame.top() + 20,
                 fmt::format("\xe2\x86\x91 the paper's bound: {}{}", lo,
                             lo == hi ? "" : fmt::format(" to {}", hi)),
                 Anchor::start, "paper-word");
    }
    frame.draw_axes(svg);
    legend.draw(svg, staircase_left, legend_top);
    return svg.finished();
}

}  // namespace dumbbell::pictures
