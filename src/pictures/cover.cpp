#include "pictures/cover.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "collisions/chart.hpp"
#include "collisions/leaf_boxes.hpp"
#include "collisions/names.hpp"
#include "number/decimal.hpp"
#include "pictures/box_panel.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::pictures {

using collisions::Chart;
using collisions::Reason;

namespace {

constexpr double cover_left = 76;
constexpr double cover_height = 400;
constexpr double between_panels = 72;
constexpr double below_heading = 24;
constexpr double above_caption = 66;

void require_few(std::size_t boxes) {
    if (boxes > most_drawn_boxes) {
        throw InputError(
            fmt::format("a picture shows {} boxes at most, and this cover has {}: dumbbell report draws "
                        "any number of them",
                        most_drawn_boxes, boxes));
    }
}

/// A reason other than a count: its colour, and what it says.
struct ReasonStyle {
    Shade shade;
    const char* words;
};

ReasonStyle style_of(Reason reason) {
    switch (reason) {
        case Reason::count:
            break;
        case Reason::outside:
            return {palette::outside, "outside the section"};
        case Reason::meets:
            return {palette::meets, "meets the bridge"};
        case Reason::meets_reversed:
            return {palette::meets_reversed, "meets the bridge, reversed"};
        case Reason::once:
            return {palette::once, "does not come back to the bridge"};
    }
    throw BrokenInvariant("a count has a colour of its own");
}

/// One chart: its boxes at the mass ratio, and what they prove.
struct Panel {
    Chart chart;
    double position_hi = 0, slope_hi = 0;
    DrawnBoxes boxes;

    /// Do its slopes go so far that an even scale would hide the small ones?
    [[nodiscard]] bool is_compact() const { return slope_hi > 4; }
};

struct DrawnCover {
    std::vector<Panel> panels;
    std::set<Count> counts;
    std::set<Reason> others;
};

/// Whether the closed range of ratios has q; of two that share it the lower one has it only at the end of
/// all.
bool has_ratio(const Rational& lo, const Rational& hi, const Rational& q, const Rational& last) {
    return lo <= q && (q < hi || hi == last) && q <= hi;
}

Panel panel_of(const collisions::ChartTree& tree, const collisions::Piece& piece, const Rational& q,
               DrawnCover& cover) {
    const collisions::Boxes boxes = collisions::leaf_boxes(tree.chart, piece.q_lo, piece.q_hi, tree.tree);
    Panel panel{tree.chart, value(boxes.hi(boxes.root, 0)), value(boxes.hi(boxes.root, 1)), {}};
    std::size_t number = 0;
    for (const collisions::Node& node : tree.tree) {
        if (node.split) {
            continue;
        }
        const collisions::BoxEnds& box = boxes.leaves.at(number++);
        if (!has_ratio(boxes.lo(box, 2), boxes.hi(box, 2), q, piece.q_hi)) {
            continue;
        }
        std::string kind;
        if (node.leaf.reason == Reason::count) {
            const Count count = 1 + node.leaf.forward + node.leaf.backward;
            cover.counts.insert(count);
            kind = count_kind(count);
        } else {
            cover.others.insert(node.leaf.reason);
            kind = name(node.leaf.reason);
        }
        panel.boxes[kind].push_back({value(boxes.lo(box, 0)), value(boxes.hi(box, 0)),
                                     value(boxes.lo(box, 1)), value(boxes.hi(box, 1))});
    }
    return panel;
}

bool is_contact(Chart chart) { return axis_name(chart, collisions::Axis::position) == "t"; }

/// Does a witness, a contact with the bridge, lie in this chart?
bool shows_witness(Chart chart) {
    return chart == Chart::bridge || chart == Chart::contact || chart == Chart::plain_contact;
}

/// The states of a chart, and its slopes (format.md, format-sections.md), for people.
struct ChartWords {
    const char* states;
    const char* slope;
};

ChartWords words_of(Chart chart) {
    constexpr const char* above_tangent = "eta: slope above the tangent, in units of 1/q";
    switch (chart) {
        case Chart::bridge:
        case Chart::contact:
        case Chart::plain_contact:
            return {"contacts of the heavy mass", above_tangent};
        case Chart::again:
            return {"the same contacts, none of which comes back to the heavy mass", above_tangent};
        case Chart::light:
            return {"turning collisions of the light mass", "lambda: slope, in units of 1/q"};
        case Chart::departure:
        case Chart::plain_departure:
            return {"collisions of the light mass", "eta: slope above the tangent"};
        case Chart::wedge:
            break;
    }
    throw BrokenInvariant("a cover picture of a wedge");
}

Frame frame_of(const Panel& panel, double x, double y, double width) {
    constexpr int wanted = 4;
    return {x,
            y,
            width,
            cover_height,
            {0, panel.position_hi,
             fmt::format("{}: angle from the corner", axis_name(panel.chart, collisions::Axis::position)),
             even_ticks(0, panel.position_hi, wanted)},
            {0, panel.slope_hi, words_of(panel.chart).slope,
             panel.is_compact() ? compact_ticks(panel.slope_hi) : even_ticks(0, panel.slope_hi, wanted),
             panel.is_compact() ? Scale::compact : Scale::linear}};
}

std::vector<LegendEntry> legend_entries(const std::set<Count>& counts, const std::set<Reason>& others) {
    std::vector<LegendEntry> entries;
    for (const Count& count : shown_counts({counts.begin(), counts.end()})) {
        entries.push_back({Swatch::area, count_kind(count), fmt::format("{}", count)});
    }
    for (const Reason reason : others) {
        entries.push_back({Swatch::area, std::string(name(reason)), style_of(reason).words});
    }
    return entries;
}

/// What explains holes in the counts of a legend.
std::string legend_note(const std::set<Count>& counts) {
    if (shown_counts({counts.begin(), counts.end()}).size() < counts.size()) {
        return " The legend has some of the counts only.";
    }
    const bool has_holes = !counts.empty() && *counts.rbegin() - *counts.begin() + 1 > Count(counts.size());
    return has_holes ? " A count that the legend leaves out belongs to no box." : "";
}

std::string caption_of(const collisions::Piece& piece, const Rational& q, std::size_t boxes,
                       const DrawnCover& cover) {
    const bool is_full = is_contact(cover.panels.front().chart);
    std::string charts;
    for (const Panel& panel : cover.panels) {
        charts += fmt::format("{}{}: {}", charts.empty() ? "" : "; ", row_of(panel.chart).name,
                              words_of(panel.chart).states);
    }
    std::string text = fmt::format(
        "q = {}: no trajectory has more than {} collisions. {} boxes cover all states of the section: charts "
        "{} ({}). In the corner the rod lies flat on the floor. Each box proves a bound{} or has another "
        "reason. "
        "Dashed: the end of a chart ({}e = \xcf\x80/2).",
        exact_text(q), *piece.upper, boxes, charts,
        is_full ? "docs/reference/format-sections.md" : "docs/reference/format.md",
        is_full ? ", counted forward from its states," : "", is_full ? "t = \xcf\x80, " : "");
    text += legend_note(cover.counts);
    if (std::any_of(cover.panels.begin(), cover.panels.end(),
                    [](const Panel& panel) { return panel.is_compact(); })) {
        text += " Great slopes v are drawn at v/(1 + v), so that the whole root box shows.";
    }
    if (piece.witness) {
        text += fmt::format(" The ring: a contact of an orbit with {} collisions.", piece.witness->total());
    }
    return text;
}

}  // namespace

Shade shade_of(Reason reason) { return style_of(reason).shade; }

std::string cover_svg(const collisions::Piece& piece, const Rational& q) {
    if (piece.cover.equal_masses) {
        throw InputError("the mass ratio 1 is proved by lemma L7, without boxes: there is no cover to draw");
    }
    require_few(static_cast<std::size_t>(piece.cover.leaves()));
    DrawnCover cover;
    std::size_t boxes = 0;
    for (const collisions::ChartTree& tree : piece.cover.charts) {
        cover.panels.push_back(panel_of(tree, piece, q, cover));
        for (const auto& kind : cover.panels.back().boxes) {
            boxes += kind.second.size();
        }
    }
    const auto panels = static_cast<double>(cover.panels.size());
    const double whole_width = page_width - cover_left - right_margin;
    const double width = (whole_width - between_panels * (panels - 1)) / panels;
    const Legend legend(legend_entries(cover.counts, cover.others), whole_width);
    const double panel_top = top_margin + below_heading + legend.height() + 30;
    const auto caption = broken_lines(caption_of(piece, q, boxes, cover), whole_width);
    const double caption_top = panel_top + cover_height + above_caption;

    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "The boxes of a cover of all collision states of a bouncing dumbbell");
    style_boxes(svg, boxes);
    svg.rules(".witness{fill:none;stroke-width:2}");
    svg.colour("witness", "stroke", palette::witness);
    colour_counts(svg, {cover.counts.begin(), cover.counts.end()});
    for (const Reason reason : cover.others) {
        svg.colour(std::string(name(reason)), "fill", style_of(reason).shade);
    }
    svg.text(cover_left, top_margin + 9, "what each box proves: at most so many collisions", Anchor::start,
             "head");
    legend.draw(svg, cover_left, top_margin + below_heading);
    double x = cover_left;
    for (const Panel& panel : cover.panels) {
        const Frame frame = frame_of(panel, x, panel_top, width);
        draw_boxes(svg, frame, panel.boxes);
        const double end = frame.x(is_contact(panel.chart) ? std::numbers::pi : std::numbers::pi / 2);
        svg.line("mark", end, frame.top(), end, frame.bottom());
        if (piece.witness && shows_witness(panel.chart)) {
            svg.circle("witness", frame.x(value(piece.witness->e)), frame.y(value(piece.witness->eta)), 5);
        }
        frame.draw_axes(svg);
        svg.text(frame.left(), frame.top() - 8, fmt::format("chart {}", row_of(panel.chart).name));
        x += width + between_panels;
    }
    draw_caption(svg, cover_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
