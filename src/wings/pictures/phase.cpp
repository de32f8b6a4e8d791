#include "pictures/phase.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

#include "base/error.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/start_plane.hpp"
#include "pictures/united_boxes.hpp"

namespace dumbbell::pictures {
namespace {

constexpr double phase_left = 76;
constexpr double phase_height = 430;

struct Region {
    std::vector<PlaneBox> boxes;
    Rational share = 0;
};

/// The powers of two of which the ends of all boxes are multiples, but no finer than a picture needs: 2^-20
/// of it is less than a thousandth of a pixel.
std::array<int, 2> fineness(const std::vector<StartCell>& cells) {
    constexpr int most = 20;
    std::array<int, 2> bits{};
    for (const StartCell& cell : cells) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            for (const Rational& end : {cell.box.lo[axis], cell.box.hi[axis]}) {
                const auto places = static_cast<int>(msb(denominator(end)));
                bits[axis] = std::min(most, std::max(bits[axis], places));
            }
        }
    }
    return bits;
}

/// x 2^bits, rounded to the nearest whole number.
long multiple(const Rational& x, int bits) {
    const Rational scaled = x * Rational(Integer(1) << static_cast<unsigned>(bits)) + Rational(1, 2);
    const Integer floor = numerator(scaled) / denominator(scaled);  // x >= 0
    return floor.convert_to<long>();
}

std::vector<Count> counts_of(const std::map<long, Region>& regions) {
    const auto counts = std::views::keys(regions);
    return {counts.begin(), counts.end()};
}

std::string percent(const Rational& share) {
    return fmt::format("{:.3g} %", 100 * share.convert_to<double>());
}

std::vector<LegendEntry> legend_entries(const std::map<long, Region>& regions, const Rational& undecided) {
    std::vector<LegendEntry> entries;
    for (const Count& count : shown_counts(counts_of(regions))) {
        entries.push_back({Swatch::area, count_kind(count),
                           fmt::format("{} ({})", count, percent(regions.at(as_long(count)).share))});
    }
    if (undecided > 0) {
        entries.push_back({Swatch::area, "hatched", fmt::format("undecided ({})", percent(undecided))});
    }
    return entries;
}

}  // namespace

std::string phase_svg(const starts::Certificate& certificate) {
    if (certificate.tree.size() / 2 >= most_phase_leaves) {
        throw InputError(
            fmt::format("a phase portrait shows {} boxes at most, and this certificate has {}: dumbbell "
                        "trace with a smaller --max-boxes",
                        most_phase_leaves, certificate.tree.size() / 2 + 1));
    }
    const StartPlane plane = start_plane(certificate);
    std::map<long, Region> regions;
    Rational undecided = 0;
    for (const StartCell& cell : plane.cells) {
        if (cell.is_exact()) {
            Region& region = regions[cell.leaf.least];
            region.boxes.push_back(cell.box);
            region.share += cell.area();
        } else {
            undecided += cell.area();
        }
    }

    const double width = page_width - phase_left - right_margin;
    const Legend legend(legend_entries(regions, undecided), width);
    const double legend_top = top_margin + 24;
    const Frame frame(phase_left, legend_top + legend.height() + 10, width, phase_height,
                      plot_axis(certificate, plane.axes[0]), plot_axis(certificate, plane.axes[1]));
    const auto caption = broken_lines(
        fmt::format("{}. Every initial condition inside a region of one colour has exactly that number of "
                    "collisions, unless both masses hit the floor at once: certified, box by box. {}",
                    fixed_quantities(certificate), undecided > 0 ? hatched_note : ""),
        width);
    const double caption_top = frame.bottom() + 66;
    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "Initial conditions of a bouncing dumbbell by their certified number of collisions");
    svg.rules(".region{stroke-width:.3;vector-effect:non-scaling-stroke;fill-rule:evenodd}");
    svg.colour("region", "stroke", {"#2b3138", "#0b0e12"});
    colour_counts(svg, counts_of(regions));

    svg.text(phase_left, top_margin + 9, "certified number of collisions (share of the picture)",
             Anchor::start, "head");
    legend.draw(svg, phase_left, legend_top);
    svg.rect("hatched", frame.left(), frame.top(), frame.width(), frame.height());
    const std::array<int, 2> bits = fineness(plane.cells);
    const auto place = [&](const PlanePoint& point) {
        return std::array{multiple(point[0], bits[0]), multiple(point[1], bits[1])};
    };
    svg.open_units(frame.left(), frame.bottom(), std::ldexp(frame.width(), -bits[0]),
                   -std::ldexp(frame.height(), -bits[1]));
    for (const auto& [count, region] : regions) {
        svg.path(fmt::format("region {}", count_kind(count)), path_of(united(region.boxes), place));
    }
    svg.close();
    frame.draw_axes(svg);
    draw_caption(svg, phase_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
