#include "pictures/shares.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "number/decimal.hpp"
#include "pictures/frame.hpp"
#include "pictures/palette.hpp"
#include "pictures/start_plane.hpp"
#include "starts/shares.hpp"

namespace dumbbell::pictures {

using starts::ShareBounds;

namespace {

constexpr double shares_left = 84;
constexpr double shares_height = 330;
constexpr long most_labelled = 20;  ///< bars with their numbers over them
constexpr double gap = 0.12;        ///< of a bar's place, on both sides

struct Bar {
    double from, to;    ///< on the axis of the counts
    double lo, hi;      ///< shares
    std::string words;  ///< the one that is proved at least; if that is 0, at most
};

/// In percent, rounded to the side on which it is true.
std::string words_of(const ShareBounds& bounds) {
    constexpr int digits = 3;
    return bounds.lo > 0
               ? fmt::format("\xe2\x89\xa5 {} %", to_text(without_zeros(cut_down(100 * bounds.lo, digits))))
               : fmt::format("\xe2\x89\xa4 {} %", to_text(without_zeros(cut_up(100 * bounds.hi, digits))));
}

/// Those that have an end and are not 0.
std::vector<Bar> bars_of(const std::vector<ShareBounds>& bounds) {
    std::vector<Bar> bars;
    for (const ShareBounds& b : bounds) {
        if (b.most && b.hi > 0) {
            bars.push_back({static_cast<double>(b.least), static_cast<double>(*b.most),
                            b.lo.convert_to<double>(), b.hi.convert_to<double>(), words_of(b)});
        }
    }
    return bars;
}

/// The greatest power of ten that leaves something of every share that is proved to be positive.
double least_share(const std::vector<Bar>& bars) {
    double least = 1;
    for (const Bar& bar : bars) {
        least = std::min(least, bar.lo > 0 ? bar.lo : bar.hi);
    }
    return std::pow(10, std::ceil(std::log10(least)) - 1);
}

std::vector<Tick> decades(double least) {
    std::vector<Tick> ticks;
    for (int power = static_cast<int>(std::lround(std::log10(least))); power <= 0; ++power) {
        const int percent = power + 2;
        ticks.push_back({std::pow(10, power), percent >= -2 ? fmt::format("{:g} %", std::pow(10, percent))
                                                            : fmt::format("1e\xe2\x88\x92{} %", -percent)});
    }
    return ticks;
}

std::vector<Tick> counts_ticks(double first, double last) {
    std::vector<Tick> ticks;
    const long step = std::max(1L, std::lround(std::ceil((last - first) / most_labelled)));
    for (long count = std::lround(first); static_cast<double>(count) <= last; count += step) {
        ticks.push_back({static_cast<double>(count), fmt::format("{}", count)});
    }
    return ticks;
}

}  // namespace

std::string shares_svg(const starts::InitialCertificate& certificate) {
    const std::vector<Bar> bars = bars_of(starts::share_bounds(certificate.tree));
    if (std::none_of(bars.begin(), bars.end(), [](const Bar& bar) { return bar.lo > 0; })) {
        throw InputError("nothing of the box is decided: dumbbell trace with a greater --max-boxes");
    }
    const double first = bars.front().from, last = bars.back().to, least = least_share(bars);
    const double width = page_width - shares_left - right_margin;
    const Legend legend(
        {{Swatch::area, "at-least", "share of the starts, at least"}, {Swatch::area, "hatched", "at most"}},
        width);
    const Frame frame(shares_left, top_margin + legend.height() + 12, width, shares_height,
                      {first - 0.5, last + 0.5, "number of collisions", counts_ticks(first, last)},
                      {least, 1.5, "share (logarithmic)", decades(least), Scale::logarithmic});
    const auto caption =
        broken_lines(fmt::format("{}. Proved, box by box: each number of collisions has at least the share "
                                 "of its bar and at most that of its hatched end.",
                                 fixed_quantities(certificate)),
                     width);
    const double caption_top = frame.bottom() + 66;
    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "How likely each number of collisions of a bouncing dumbbell is");
    svg.colour("at-least", "fill", palette::proved);
    legend.draw(svg, shares_left, top_margin);
    frame.draw_grid(svg);
    for (const Bar& bar : bars) {
        const double x = frame.x(bar.from - 0.5 + gap), right = frame.x(bar.to + 0.5 - gap);
        const double bottom = bar.lo > 0 ? frame.y(bar.lo) : frame.bottom(), top = frame.y(bar.hi);
        svg.rect("hatched", x, top, right - x, bottom - top);
        if (bar.lo > 0) {
            svg.rect("at-least", x, bottom, right - x, frame.bottom() - bottom);
        }
        if (last - first < most_labelled) {
            svg.text((x + right) / 2, top - 5, bar.words, Anchor::middle);
        }
    }
    frame.draw_axes(svg);
    draw_caption(svg, shares_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
