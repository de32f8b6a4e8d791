#include "pictures/body_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "collisions/claim.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/frame.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::pictures {

using collisions::Certificate;
using collisions::Piece;
using collisions::Status;

namespace {

constexpr double map_left = 64;
constexpr double map_height = 460;
constexpr double least_greatest_inertia = 12;  // room for the coin and what lies above it

/// rho and the inertia of two ends of the mass ratio q and a uniform rod of mu times their mass.
std::pair<double, double> rod_body(double q, double mu) {
    const auto claim = claim_of(collisions::Rod{exact(q), exact(mu)});
    return {value(*claim.system.rho), value(claim.range.lo)};
}

/// From no mass of the rod to ten thousand times the mass of its ends.
std::string rods(const Frame& frame, double q) {
    const auto [rho, inertia] = rod_body(q, 0);
    const auto heavier = frame.curve([&](double share) { return rod_body(q, std::pow(10, 8 * share - 4)); });
    return fmt::format("M{:.2f} {:.2f}L{}", frame.x(rho), frame.y(inertia), heavier.substr(1));
}

/// Its class: its maximum, if that is one value.
std::string kind_of(const Piece& piece) {
    return piece.status() == Status::exact ? count_kind(piece.lower) : "hatched";
}

void draw_piece(Svg& svg, const Frame& frame, const Rational& rho, const Piece& piece) {
    const double x = frame.x(value(rho));
    const double top = frame.y(value(piece.q_hi));
    const double height = frame.y(value(piece.q_lo)) - top;
    constexpr double radius = 9;
    if (piece.q_lo == piece.q_hi) {
        svg.circle(kind_of(piece), x, top, radius);
    } else {
        svg.rect(kind_of(piece), x - radius / 2, top, radius, height);
    }
}

Legend legend_of(const std::vector<Count>& counts, bool has_undecided, double width) {
    std::vector<LegendEntry> entries;
    for (const Count& count : shown_counts(counts)) {
        entries.push_back({Swatch::area, count_kind(count), fmt::format("N = {}", count)});
    }
    if (has_undecided) {
        entries.push_back({Swatch::area, "hatched", "not decided"});
    }
    entries.push_back({Swatch::curve, "massless", "massless rods, Q rho = 1"});
    entries.push_back({Swatch::curve, "rods", "rods of growing mass, ends 1, 3, 10"});
    return {std::move(entries), width};
}

}  // namespace

std::string body_map_svg(const std::vector<Certificate>& certificates) {
    require(!certificates.empty(), "map of bodies: no certificate");
    std::set<Count> counts;
    bool has_undecided = false;
    double greatest = least_greatest_inertia;
    for (const Certificate& certificate : certificates) {
        greatest = std::max(greatest, value(certificate.q_hi()));
        for (const Piece& piece : certificate.pieces) {
            piece.status() == Status::exact ? (void)counts.insert(piece.lower) : (void)(has_undecided = true);
        }
    }
    const std::vector<Count> shown(counts.begin(), counts.end());
    const double width = page_width - map_left - right_margin;
    const double legend_top = top_margin + 24;
    const Legend legend = legend_of(shown, has_undecided, width);
    const double hi = greatest * 1.1;
    const Frame frame(map_left, legend_top + legend.height() + 10, width, map_height,
                      {0, 1.16, "rho = d2/d1", even_ticks(0, 1, 5)},
                      {0.94, hi, "Q = (d1/k)\xc2\xb2 (logarithmic)",
                       decade_ticks(0.94, hi, {map_height, true}), Scale::logarithmic});

    const std::string title = "The greatest number of collisions of rigid bodies";
    Svg svg(page_width, frame.bottom() + 52, title);
    svg.rules(
        ".massless,.rods{fill:none;stroke-width:2}.rods{stroke-width:1.4}.body{fill:none;stroke-width:2}");
    svg.colour("massless", "stroke", palette::growth);
    svg.colour("rods", "stroke", palette::paper);
    svg.colour("body", "stroke", palette::witness);
    colour_counts(svg, shown);
    svg.text(map_left, top_margin + 9, title, Anchor::start, "head");
    frame.draw_grid(svg);
    frame.open_clip(svg);
    for (const Certificate& certificate : certificates) {
        for (const Piece& piece : certificate.pieces) {
            draw_piece(svg, frame, *certificate.system.rho, piece);
        }
    }
    svg.path("massless", frame.curve([&](double share) {
        const double inertia = std::pow(hi, share);
        return std::pair(1 / inertia, inertia);
    }));
    for (const double q : {1.0, 3.0, 10.0}) {
        svg.path("rods", rods(frame, q));
    }
    svg.close();
    for (const auto& [inertia, name] : {std::pair(2.0, "ring"), {3.0, "uniform rod"}, {4.0, "coin"}}) {
        svg.circle("body", frame.x(1), frame.y(inertia), 12);
        svg.text(frame.x(1) + 18, frame.y(inertia) + 4, name);
    }
    frame.draw_axes(svg);
    legend.draw(svg, map_left, legend_top);
    return svg.finished();
}

}  // namespace dumbbell::pictures
