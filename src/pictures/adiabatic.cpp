#include "pictures/adiabatic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "adiabatic/orbit.hpp"
#include "base/error.hpp"
#include "number/decimal.hpp"
#include "pictures/frame.hpp"
#include "pictures/palette.hpp"
#include "words/printed.hpp"

namespace dumbbell::pictures {

namespace {

constexpr double adiabatic_left = 84;
constexpr double plot_height = 220;
constexpr double below_panel = 66;
constexpr long least_plotted_bounces = 5;  // of fewer there is no curve

/// What is enclosed just before a collision.
struct Bounce {
    double speed;        ///< |phidot|, relative to the first
    double f;            ///< relative to the first
    Interval change;     ///< I - I_0 before the collision
    Interval invariant;  ///< I / I_0
};

struct Attained {
    std::vector<Bounce> bounces;
    std::optional<Interval> after;  ///< of a scattering: I - I_0 after the last collision
};

Attained enclosed(const adiabatic::Certificate& certificate) {
    const adiabatic::State& state = certificate.attained.front();
    if (state.n > most_plotted_bounces) {
        throw InputError(
            fmt::format("a picture shows {} collisions at most, and the orbit of this certificate has {}",
                        most_plotted_bounces, state.n + 1));
    }
    if (state.n + 1 < least_plotted_bounces) {
        throw InputError(fmt::format(
            "a picture of the invariant needs {} collisions, and the orbit of this certificate has "
            "{}: dumbbell report shows them",
            least_plotted_bounces, state.n + 1));
    }
    adiabatic::Orbit<Interval> orbit(enclose<Interval>(state.u), enclose<Interval>(state.s),
                                     enclose<Interval>(state.delta));
    const Interval first_f = orbit.at().f;
    Attained result;
    for (long n = 0;; ++n) {
        result.bounces.push_back({approximate(orbit.speed()), approximate(orbit.at().f / first_f),
                                  orbit.change(), Interval(1) + orbit.change() / first_f});
        if (n == state.n) {
            break;
        }
        if (!orbit.advance()) {
            throw InputError("double precision does not enclose the orbit of this certificate");
        }
    }
    if (certificate.hypotheses.claim != adiabatic::Claim::run) {
        result.after = orbit.change_behind();
    }
    return result;
}

/// The claim's unit of I - I_0, how the picture names that in it, and the unit itself.
struct Unit {
    double size;
    const char* name;
    const char* word;
};

Unit unit_of(const adiabatic::Certificate& certificate) {
    const auto delta = certificate.attained.front().delta.convert_to<double>();
    switch (certificate.hypotheses.claim) {
        case adiabatic::Claim::run:
            return {delta, "(I_n \xe2\x88\x92 I_0) / delta", "delta"};
        case adiabatic::Claim::scattering:
            return {std::sqrt(delta),
                    "(I_n \xe2\x88\x92 I_0) / \xe2\x88\x9a"
                    "delta",
                    "\xe2\x88\x9a"
                    "delta"};
        case adiabatic::Claim::bounce:
            break;
    }
    throw InputError(
        "this certificate is about single bounces: plot adiabatic needs one with --theorem thm3.3 or thm3.5");
}

/// The bound that is proved for all orbits, in the claim's unit. One far beyond what the orbit does would
/// squeeze its curve into a line: it is told in words.
struct Bound {
    double value;
    std::string text;
    bool is_drawn;

    Bound(const adiabatic::Certificate& certificate, const Unit& unit, double greatest_change)
        : value(certificate.bounds.front().convert_to<double>()),
          text(fmt::format("{} {}", exact_text(certificate.bounds.front()), unit.word)) {
        constexpr double far = 3;
        is_drawn = value <= far * greatest_change;
    }
};

constexpr const char* bound_words = "proved for all orbits";

template <class Value>
std::string path_of(const Frame& frame, const std::vector<Bounce>& bounces, const Value& value) {
    std::string path;
    for (std::size_t n = 0; n < bounces.size(); ++n) {
        path += fmt::format("{}{} {}", n == 0 ? 'M' : 'L', px(frame.x(static_cast<double>(n))),
                            px(frame.y(value(bounces[n]))));
    }
    return path;
}

/// What lies after the last collision stands where the next one would be.
PlotAxis numbers_axis(const Attained& orbit) {
    const auto last = static_cast<double>(orbit.bounces.size() - 1);
    return {0, last + (orbit.after ? 1 : 0), "collision n",
            even_ticks(0, last, std::min(10, static_cast<int>(last)))};
}

void style_adiabatic(Svg& svg) {
    svg.rules(
        ".speed,.f,.invariant,.bound{fill:none;stroke-width:1.8}.speed{stroke-dasharray:6 "
        "3}.f{stroke-dasharray:2 2.5}"
        ".invariant{stroke-width:2.4}.after{fill:none;stroke-width:2}.bound{stroke-dasharray:9 3 2 3}");
    svg.colour("speed", "stroke", {"#c46a00", "#ffb347"});
    svg.colour("f", "stroke", {"#0a7d5a", "#4fd6a6"});
    svg.colour("invariant", "stroke", palette::proved);
    svg.colour("bounce", "fill", palette::proved);
    svg.colour("after", "stroke", palette::proved);
    svg.colour("bound", "stroke", {"#a3195b", "#ff8ac0"});
    svg.colour("bound-word", "fill", {"#a3195b", "#ff8ac0"});
}

/// The factors of the invariant and the invariant, each relative to its first value.
void draw_factors(Svg& svg, const Frame& frame, const Attained& orbit) {
    frame.draw_grid(svg);
    svg.path("speed", path_of(frame, orbit.bounces, [](const Bounce& b) { return b.speed; }));
    svg.path("f", path_of(frame, orbit.bounces, [](const Bounce& b) { return b.f; }));
    svg.path("invariant",
             path_of(frame, orbit.bounces, [](const Bounce& b) { return approximate(b.invariant); }));
    frame.draw_axes(svg);
}

void draw_changes(Svg& svg, const Frame& frame, const Attained& orbit, double unit, const Bound& bound) {
    constexpr std::size_t many = 200;  // dots that would merge
    frame.draw_grid(svg);
    for (const double sign : {-1.0, 1.0}) {
        if (bound.is_drawn) {
            const double y = frame.y(sign * bound.value);
            svg.line("bound", frame.left(), y, frame.right(), y);
        }
    }
    if (!bound.is_drawn) {
        svg.text(frame.left() + 10, frame.top() + 20,
                 fmt::format("\xe2\x86\x91 {}: \xc2\xb1{}", bound_words, bound.text), Anchor::start,
                 "bound-word");
    }
    const auto change = [&](const Bounce& b) { return approximate(b.change) / unit; };
    std::string path = path_of(frame, orbit.bounces, change);
    if (orbit.after) {
        path += fmt::format("L{} {}", px(frame.right()), px(frame.y(approximate(*orbit.after) / unit)));
    }
    svg.path("invariant", path);
    for (std::size_t n = 0; n < orbit.bounces.size() && orbit.bounces.size() <= many; ++n) {
        svg.circle("bounce", frame.x(static_cast<double>(n)), frame.y(change(orbit.bounces[n])), 2.6);
    }
    if (orbit.after) {
        svg.circle("after", frame.right(), frame.y(approximate(*orbit.after) / unit), 5);
    }
    frame.draw_axes(svg);
}

std::string caption_of(const adiabatic::Certificate& certificate, const Attained& orbit) {
    double widest = 0;
    for (const Bounce& b : orbit.bounces) {
        widest = std::max(widest, width(b.change));
    }
    const adiabatic::State& state = certificate.attained.front();
    const Interval& end = orbit.after ? *orbit.after : orbit.bounces.back().change;
    return fmt::format(
        "delta = {}, |phidot| = 1 and ydot = "
        "\xe2\x88\x92{} delta before collision 0, at {} rad from the vertical. I = |phidot| f with f = "
        "\xcf\x80 \xe2\x88\x92 arccos y, y in rod lengths, is enclosed at every collision to {}. Dots: "
        "before each collision{}. "
        "In the "
        "end it has changed by about {}{:.4g}.",
        exact_text(state.delta), to_decimal(state.s, 4), to_decimal(state.u, 4), rounded_up(widest),
        orbit.after ? "; ring: after the last one" : "", approximate(end) < 0 ? "\xe2\x88\x92" : "",
        std::abs(approximate(end)));
}

}  // namespace

std::string adiabatic_svg(const adiabatic::Certificate& certificate) {
    const Unit unit = unit_of(certificate);
    const Attained orbit = enclosed(certificate);
    double factor_hi = 1;
    double factor_lo = 1;
    double change_hi = 0;
    for (const Bounce& b : orbit.bounces) {
        factor_hi = std::max({factor_hi, b.speed, b.f, b.invariant.hi()});
        factor_lo = std::min({factor_lo, b.speed, b.f, b.invariant.lo()});
        change_hi = std::max(change_hi, abs(b.change).hi() / unit.size);
    }
    const double margin = 0.08 * (factor_hi - factor_lo);
    if (orbit.after) {
        change_hi = std::max(change_hi, abs(*orbit.after).hi() / unit.size);
    }
    const Bound bound(certificate, unit, change_hi);
    change_hi = 1.12 * (bound.is_drawn ? std::max(change_hi, bound.value) : change_hi);

    std::vector<LegendEntry> entries{{Swatch::curve, "speed", "|phidot|"},
                                     {Swatch::curve, "f", "f = \xcf\x80 \xe2\x88\x92 arccos y"},
                                     {Swatch::curve, "invariant", "I = |phidot| f"}};
    if (bound.is_drawn) {
        entries.push_back({Swatch::curve, "bound", fmt::format("{}: {}", bound_words, bound.text)});
    }
    const double whole_width = page_width - adiabatic_left - right_margin;
    const Legend legend(std::move(entries), whole_width);
    const Frame factors(adiabatic_left, top_margin + legend.height() + 10, whole_width, plot_height,
                        numbers_axis(orbit),
                        {factor_lo - margin, factor_hi + margin, "relative to the start",
                         even_ticks(factor_lo - margin, factor_hi + margin, 5)});
    const Frame changes(adiabatic_left, factors.bottom() + below_panel, whole_width, plot_height,
                        numbers_axis(orbit),
                        {-change_hi, change_hi, unit.name, even_ticks(-change_hi, change_hi, 6)});
    const auto caption = broken_lines(caption_of(certificate, orbit), whole_width);
    const double caption_top = changes.bottom() + below_panel;
    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "The adiabatic invariant of a bouncing dumbbell along an orbit");
    style_adiabatic(svg);
    legend.draw(svg, adiabatic_left, top_margin);
    draw_factors(svg, factors, orbit);
    draw_changes(svg, changes, orbit, unit.size, bound);
    draw_caption(svg, adiabatic_left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell::pictures
