#include "pictures/law.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "law/constants.hpp"
#include "pictures/frame.hpp"
#include "pictures/palette.hpp"
#include "pictures/staircase.hpp"

namespace dumbbell::pictures {

using collisions::Piece;
using collisions::Status;

namespace {

constexpr double law_left = 64;
constexpr double teeth_height = 320;
constexpr double steps_height = 190;
constexpr double between = 84;  ///< from one frame to the next

// N(q) - C sqrt q lies between these for every q >= 1 (Theorem B).
constexpr double lowest = 0.980;
constexpr double greatest = 2.115;

double fourth_root(double q) { return std::sqrt(std::sqrt(q)); }

/// A height for each mass ratio.
using Curve = std::function<double(double)>;

/// The law, in the doubles of a picture.
struct Law {
    double C;
    double c0;

    Law() {
        const law::Constants constants;
        C = approximate(constants.C);
        c0 = approximate(constants.c0);
        kappa = approximate(constants.kappa);
    }

    /// n - C sqrt q.
    [[nodiscard]] Curve excess(long n) const {
        return [C = C, n](double q) { return static_cast<double>(n) - C * std::sqrt(q); };
    }
    /// How far the law's bounds may be below this height.
    [[nodiscard]] Curve strip_below(double height) const {
        return [c0 = c0, height](double q) { return height - c0 / fourth_root(q); };
    }
    /// The fourth root of q times C sqrt q - (n - 2): of q_c(n) between 0 and c0, if n >= 9.
    [[nodiscard]] double lateness(long n, double q) const { return fourth_root(q) * (2 - excess(n)(q)); }
    // The bounds of that by Theorem A, the lower one for even n, the upper one for odd n, and a ratio from
    // where on all steps have them: C sqrt q < 902 at q_c(903).
    [[nodiscard]] Curve theorem_a_low() const { return after_logarithm(0.497 + 0.072, 2.6); }
    [[nodiscard]] Curve theorem_a_high() const { return after_logarithm(0.38 - 0.072, -2.6); }
    [[nodiscard]] double theorem_a_from() const { return std::pow(902 / C, 2); }

  private:
    [[nodiscard]] Curve after_logarithm(double constant, double next) const {
        return [c0 = c0, kappa = kappa, constant, next](double q) {
            const double s = 1 / fourth_root(q);
            return c0 - (kappa * std::log(q) + constant + next * s) * s;
        };
    }
    double kappa;
};

struct Range {
    double lo;
    double hi;
};

/// The curve over a range, with a point for about every third pixel.
std::vector<std::string> points(const Frame& frame, const Range& range, const Curve& curve) {
    const int parts = std::max(1, static_cast<int>((frame.x(range.hi) - frame.x(range.lo)) / 3));
    std::vector<std::string> result;
    for (int i = 0; i <= parts; ++i) {
        const double q =
            i == parts ? range.hi : range.lo * std::pow(range.hi / range.lo, static_cast<double>(i) / parts);
        result.push_back(fmt::format("{} {}", px(frame.x(q)), px(frame.y(curve(q)))));
    }
    return result;
}

std::string line(const std::vector<std::string>& points) {
    std::string path;
    for (const std::string& point : points) {
        path += (path.empty() ? 'M' : 'L') + point;
    }
    return path;
}

std::string area(const Frame& frame, const Range& range, const Curve& low, const Curve& high) {
    std::vector<std::string> around = points(frame, range, low);
    const std::vector<std::string> back = points(frame, range, high);
    around.insert(around.end(), back.rbegin(), back.rend());
    return line(around) + 'z';
}

Curve level(double height) {
    return [height](double /*q*/) { return height; };
}

/// Marks at powers of ten, as many as have room; in a range of few of them the usual ones.
std::vector<Tick> power_ticks(const Range& range, double width) {
    constexpr int few = 3;
    constexpr int most = 20;
    constexpr double slack = 1e-9;
    const int first = static_cast<int>(std::ceil(std::log10(range.lo) - slack));
    const int last = static_cast<int>(std::floor(std::log10(range.hi) + slack));
    if (last - first < few) {
        return decade_ticks(range.lo, range.hi, {width});
    }
    static constexpr std::array raised{"\xe2\x81\xb0", "\xc2\xb9",     "\xc2\xb2",     "\xc2\xb3",
                                       "\xe2\x81\xb4", "\xe2\x81\xb5", "\xe2\x81\xb6", "\xe2\x81\xb7",
                                       "\xe2\x81\xb8", "\xe2\x81\xb9"};
    std::vector<Tick> ticks;
    for (int power = first; power <= last; power += (last - first) / most + 1) {
        std::string label = power == 0 ? "1" : "10";
        for (const char digit : power > 1 ? std::to_string(power) : "") {
            label += raised.at(static_cast<std::size_t>(digit - '0'));
        }
        ticks.push_back({std::pow(10, power), label});
    }
    return ticks;
}

PlotAxis ratio_axis(const Range& range, double width) {
    return {range.lo, range.hi, "mass ratio q (heavy over light, logarithmic)", power_ticks(range, width),
            Scale::logarithmic};
}

/// N(q) - C sqrt q on the pieces that begin before q_end, where one value is proved: a tooth for each.
std::string teeth_path(const Frame& frame, const Law& law, const std::vector<Piece>& pieces, double q_end) {
    std::string path;
    for (const Piece& piece : pieces) {
        if (piece.status() == Status::exact && value(piece.q_lo) < q_end) {
            path += line(
                points(frame, {value(piece.q_lo), value(piece.q_hi)}, law.excess(as_long(*piece.upper))));
        }
    }
    return path;
}

/// What lies between the two values of a gap, unless that is thinner than the picture's coordinates tell.
std::string gap_path(const Frame& frame, const Law& law, const std::vector<Piece>& pieces) {
    std::string path;
    for (const Piece& piece : pieces) {
        const Range range{value(piece.q_lo), value(piece.q_hi)};
        if (piece.status() == Status::gap && px(frame.x(range.lo)) != px(frame.x(range.hi))) {
            path += area(frame, range, law.excess(as_long(piece.lower)), law.excess(as_long(*piece.upper)));
        }
    }
    return path;
}

/// The steps before q_end, each between two pieces with one value, as far apart as these are.
std::string steps_path(const Frame& frame, const Law& law, const std::vector<Piece>& pieces, double q_end) {
    std::string path;
    const Piece* before = nullptr;
    for (const Piece& piece : pieces) {
        if (piece.status() != Status::exact || value(piece.q_lo) > q_end) {
            continue;
        }
        if (before != nullptr && *piece.upper == *before->upper + 1) {
            const double lo = value(before->q_hi), hi = value(piece.q_lo);
            path += fmt::format("M{} {}L{} {}", px(frame.x(lo)),
                                px(frame.y(law.lateness(as_long(*piece.upper), lo))), px(frame.x(hi)),
                                px(frame.y(law.lateness(as_long(*piece.upper), hi))));
        }
        before = &piece;
    }
    return path;
}

struct Content {
    const std::vector<Piece>& pieces;
    Law law;
    Range all;    ///< of the picture
    Range known;  ///< of the pieces

    [[nodiscard]] bool has_open() const {
        return std::any_of(pieces.begin(), pieces.end(),
                           [](const Piece& piece) { return piece.status() == Status::open; });
    }
};

void draw_teeth(Svg& svg, const Frame& frame, const Content& content) {
    const auto& [pieces, law, all, known] = content;
    const Range lawful{std::max(all.lo, law_from), all.hi};
    draw_open(svg, frame, pieces);
    frame.open_clip(svg);
    svg.path("law", area(frame, {known.hi, all.hi}, law.strip_below(1), level(2)));
    svg.path("strip", area(frame, lawful, law.strip_below(1), level(1)) +
                          area(frame, lawful, law.strip_below(2), level(2)));
    svg.close();
    frame.draw_grid(svg);
    frame.open_clip(svg);
    if (const std::string gaps = gap_path(frame, law, pieces); !gaps.empty()) {
        svg.path("gap", gaps);
    }
    svg.path("proved", teeth_path(frame, law, pieces, all.hi));
    svg.path("bounds", line(points(frame, all, level(greatest))) + line(points(frame, all, level(lowest))));
    svg.close();
    if (all.lo < law_from) {
        svg.open_clip(frame.left(), frame.top(), frame.x(law_from) - frame.left(), frame.y(2) - frame.top());
        svg.path("exception", teeth_path(frame, law, pieces, law_from));
        svg.close();
    }
    svg.text(frame.right() - 8, frame.y(greatest) - 5, fmt::format("{:.3f}", greatest), Anchor::end);
    svg.text(frame.right() - 8, frame.y(lowest) + 15, fmt::format("{:.3f}", lowest), Anchor::end);
    frame.draw_axes(svg);
}

void draw_steps(Svg& svg, const Frame& frame, const Content& content) {
    const auto& [pieces, law, all, known] = content;
    const Range lawful{std::max(all.lo, law_from), all.hi};
    const double narrow = std::max(lawful.lo, law.theorem_a_from());
    draw_open(svg, frame, pieces);
    frame.open_clip(svg);
    svg.path("strip", area(frame, lawful, level(0), level(law.c0)));
    if (narrow < all.hi) {
        svg.path("law", area(frame, {narrow, all.hi}, law.theorem_a_low(), law.theorem_a_high()));
    }
    svg.close();
    frame.draw_grid(svg);
    frame.open_clip(svg);
    svg.path("step", steps_path(frame, law, pieces, all.hi));
    svg.close();
    if (all.lo < law_from) {
        svg.open_clip(frame.left(), frame.y(0), frame.x(law_from) - frame.left(),
                      frame.bottom() - frame.y(0));
        svg.path("exception", steps_path(frame, law, pieces, law_from));
        svg.close();
    }
    frame.draw_axes(svg);
}

void law_style(Svg& svg) {
    svg.rules(
        ".proved,.exception,.step,.bounds{fill:none}.proved,.exception,.step{stroke-linecap:round}"
        ".proved{stroke-width:1.4}.step{stroke-width:3}.exception{stroke-width:3.2}"
        ".bounds{stroke-width:1.5;stroke-dasharray:6 4}.strip{fill-opacity:0.55}");
    svg.colour("proved", "stroke", palette::proved);
    svg.colour("step", "stroke", palette::proved);
    svg.colour("exception", "stroke", palette::paper);
    svg.colour("bounds", "stroke", palette::growth);
    svg.colour("law", "fill", palette::law);
    svg.colour("gap", "fill", palette::gap);
    svg.colour("strip", "fill", palette::gap);
}

/// Of the pieces, that is, and of the law.
std::vector<LegendEntry> legend_entries(const Content& content) {
    std::vector<LegendEntry> entries{{Swatch::curve, "proved", "proved by the certificate"}};
    if (content.has_open()) {
        entries.push_back({Swatch::area, "hatched", "not decided by it"});
    }
    if (content.all.lo < law_from) {
        entries.push_back({Swatch::curve, "exception", "above 2: below q_c(9) only"});
    }
    entries.push_back({Swatch::area, "law", "proved by the law, beyond the certificate"});
    entries.push_back({Swatch::area, "strip", "where the law, or a gap, leaves two values"});
    entries.push_back({Swatch::curve, "bounds", "no q \xe2\x89\xa5 1 is outside (the law)"});
    return entries;
}

constexpr const char* caption =
    "The law (Theorem B of proofs/law.md): 2 + \xe2\x8c\x8a"
    "C \xe2\x88\x9aq \xe2\x88\x92 c0 q^(\xe2\x88\x92"
    "1/4)\xe2\x8c\x8b \xe2\x89\xa4 N(q) \xe2\x89\xa4 2 + \xe2\x8c\x8a"
    "C \xe2\x88\x9aq\xe2\x8c\x8b for every q \xe2\x89\xa5 q_c(9) = 62.7..., and so N(q) \xe2\x88\x92 C "
    "\xe2\x88\x9aq lies in (1 \xe2\x88\x92 c0 q^(\xe2\x88\x92"
    "1/4), 2]. Lower picture: each step is a dot where the certificate encloses it; the law has all steps "
    "from q_c(9) "
    "on in the strip of height c0, and those from q_c(903) on in the area inside it (Theorem A). C = {:.4f}, "
    "c0 = {:.4f}.";

constexpr const char* title = "How far the greatest number of collisions is from C \xe2\x88\x9aq";

}  // namespace

std::string law_svg(const std::vector<Piece>& pieces, double q_end) {
    require(!pieces.empty() && pieces.front().q_lo < pieces.back().q_hi, "law picture: an empty range");
    const Range known{value(pieces.front().q_lo), value(pieces.back().q_hi)};
    require(law_from <= known.hi && known.hi < q_end, "law picture: a range that the law does not continue");
    const Content content{pieces, {}, {known.lo, q_end}, known};
    const double width = page_width - law_left - right_margin;
    const Legend legend(legend_entries(content), width);
    const double legend_top = top_margin + 24;
    const Frame teeth(law_left, legend_top + legend.height() + 10, width, teeth_height,
                      ratio_axis(content.all, width),
                      {0.9, 2.2, "N(q) \xe2\x88\x92 C \xe2\x88\x9aq", even_ticks(0.9, 2.2, 7)});
    const Frame steps(law_left, teeth.bottom() + between, width, steps_height, ratio_axis(content.all, width),
                      {-0.16, 0.24, "", even_ticks(-0.16, 0.24, 4)});
    const auto words = broken_lines(fmt::format(caption, content.law.C, content.law.c0), width);
    const double caption_top = steps.bottom() + 66;

    Svg svg(page_width, caption_top + caption_step * static_cast<double>(words.size()), title);
    law_style(svg);
    svg.text(law_left, top_margin + 9, title, Anchor::start, "head");
    legend.draw(svg, law_left, legend_top);
    draw_teeth(svg, teeth, content);
    svg.text(
        law_left, steps.top() - 12,
        "How late the steps are: (C \xe2\x88\x9aq \xe2\x88\x92 (N \xe2\x88\x92 2)) q^(1/4) at q = q_c(N)");
    draw_steps(svg, steps, content);
    draw_caption(svg, law_left, caption_top, words);
    return svg.finished();
}

}  // namespace dumbbell::pictures
