#include "report/adiabatic_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "arith/decimal.hpp"
#include "arith/error.hpp"
#include "model/adiabatic_orbit.hpp"
#include "report/plot_frame.hpp"
#include "report/printed.hpp"

namespace dumbbell {
namespace {

constexpr double left = 84;
constexpr double plot_height = 220;
constexpr double below_axes = 66;

/// What is enclosed of one collision: before it, and the invariant behind it, too.
struct Bounce {
    double speed;        ///< |phidot|, relative to the first
    double f;            ///< relative to the first
    Interval change;     ///< I - I_0 before the collision
    Interval invariant;  ///< I / I_0
};

struct Orbit {
    std::vector<Bounce> bounces;
    std::optional<Interval> behind;  ///< of a scattering: I - I_0 after the last collision
};

Orbit enclosed(const AdiabaticCertificate& certificate) {
    const AdiabaticState& state = certificate.attained.front();
    if (state.n > most_plotted_bounces) {
        throw InputError(
            fmt::format("a picture shows {} collisions at most, and the orbit of this certificate has {}",
                        most_plotted_bounces, state.n + 1));
    }
    AdiabaticOrbit<Interval> orbit(enclose<Interval>(state.u), enclose<Interval>(state.s),
                                   enclose<Interval>(state.delta));
    const Interval first_f = orbit.at().f;
    Orbit result;
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
    if (certificate.hypotheses.claim != AdiabaticClaim::run) {
        result.behind = orbit.change_behind();
    }
    return result;
}

/// The claim's unit of I - I_0, how the picture names that in it, and the unit itself.
struct Unit {
    double size;
    const char* name;
    const char* word;
};

Unit unit_of(const AdiabaticCertificate& certificate) {
    const auto delta = certificate.attained.front().delta.convert_to<double>();
    switch (certificate.hypotheses.claim) {
        case AdiabaticClaim::run:
            return {delta, "(I_n \xe2\x88\x92 I_0) / delta", "delta"};
        case AdiabaticClaim::scattering:
            return {std::sqrt(delta),
                    "(I_n \xe2\x88\x92 I_0) / \xe2\x88\x9a"
                    "delta",
                    "\xe2\x88\x9a"
                    "delta"};
        case AdiabaticClaim::printed:
            return {1, "I_n \xe2\x88\x92 I_0", ""};
        case AdiabaticClaim::bounce:
            break;
    }
    throw InputError(
        "this certificate is about single bounces: plot adiabatic needs one with --theorem thm3.3, thm3.5 or "
        "printed");
}

template <class Value>
std::string path_of(const Frame& frame, const std::vector<Bounce>& bounces, const Value& value) {
    std::string path;
    for (std::size_t n = 0; n < bounces.size(); ++n) {
        fmt::format_to(std::back_inserter(path), "{}{} {}", n == 0 ? 'M' : 'L',
                       px(frame.x(static_cast<double>(n))), px(frame.y(value(bounces[n]))));
    }
    return path;
}

PlotAxis numbers_axis(std::size_t bounces) {
    const auto last = static_cast<double>(bounces - 1);
    const double hi = std::max(last, 1.0);
    return {0, hi, "collision n", even_ticks(0, hi, std::min(10, static_cast<int>(hi)))};
}

void style(Svg& svg) {
    svg.rules(
        ".speed,.f,.invariant,.bound{fill:none;stroke-width:1.8}.speed{stroke-dasharray:6 "
        "3}.f{stroke-dasharray:2 2.5}"
        ".invariant{stroke-width:2.4}.behind{fill:none;stroke-width:2}.bound{stroke-dasharray:9 3 2 3}");
    svg.colour("speed", "stroke", {"#c46a00", "#ffb347"});
    svg.colour("f", "stroke", {"#0a7d5a", "#4fd6a6"});
    svg.colour("invariant", "stroke", {"#0055a4", "#63adff"});
    svg.colour("bounce", "fill", {"#0055a4", "#63adff"});
    svg.colour("behind", "stroke", {"#0055a4", "#63adff"});
    svg.colour("bound", "stroke", {"#a3195b", "#ff8ac0"});
}

/// The factors of the invariant and the invariant, each relative to its first value.
void draw_factors(Svg& svg, const Frame& frame, const Orbit& orbit) {
    frame.draw_grid(svg);
    svg.path("speed", path_of(frame, orbit.bounces, [](const Bounce& b) { return b.speed; }));
    svg.path("f", path_of(frame, orbit.bounces, [](const Bounce& b) { return b.f; }));
    svg.path("invariant",
             path_of(frame, orbit.bounces, [](const Bounce& b) { return approximate(b.invariant); }));
    frame.draw_axes(svg);
}

void draw_changes(Svg& svg, const Frame& frame, const Orbit& orbit, double unit,
                  const std::optional<double>& bound) {
    constexpr std::size_t many = 200;  // dots that would merge
    frame.draw_grid(svg);
    if (bound) {
        for (const double sign : {-1.0, 1.0}) {
            svg.line("bound", frame.left(), frame.y(sign * *bound), frame.right(), frame.y(sign * *bound));
        }
    }
    const auto change = [&](const Bounce& b) { return approximate(b.change) / unit; };
    svg.path("invariant", path_of(frame, orbit.bounces, change));
    for (std::size_t n = 0; n < orbit.bounces.size() && orbit.bounces.size() <= many; ++n) {
        svg.circle("bounce", frame.x(static_cast<double>(n)), frame.y(change(orbit.bounces[n])), 2.6);
    }
    if (orbit.behind) {
        svg.circle("behind", frame.right(), frame.y(approximate(*orbit.behind) / unit), 5);
    }
    frame.draw_axes(svg);
}

std::string caption_of(const AdiabaticCertificate& certificate, const Orbit& orbit) {
    double widest = 0;
    for (const Bounce& b : orbit.bounces) {
        widest = std::max(widest, width(b.change));
    }
    const AdiabaticState& state = certificate.attained.front();
    const Interval& end = orbit.behind ? *orbit.behind : orbit.bounces.back().change;
    return fmt::format(
        "delta = {}, |phidot| = 1 and ydot = "
        "\xe2\x88\x92{} delta before collision 0, at {} rad from the vertical. I = |phidot| f with f = "
        "\xcf\x80 \xe2\x88\x92 arccos y is enclosed at every collision to {}. Dots: before each collision{}. "
        "In the "
        "end it has changed by about {}{:.4g}.",
        exact_text(state.delta), to_decimal(state.s, 4), to_decimal(state.u, 4), rounded_up(widest),
        orbit.behind ? "; ring: behind the last one" : "", approximate(end) < 0 ? "\xe2\x88\x92" : "",
        std::abs(approximate(end)));
}

}  // namespace

std::string adiabatic_svg(const AdiabaticCertificate& certificate) {
    const Unit unit = unit_of(certificate);
    const Orbit orbit = enclosed(certificate);
    std::optional<double> bound;
    if (!certificate.bounds.empty()) {
        bound = certificate.bounds.front().convert_to<double>();
    }
    double factor_hi = 1;
    double factor_lo = 1;
    double change_hi = bound.value_or(0);
    for (const Bounce& b : orbit.bounces) {
        factor_hi = std::max({factor_hi, b.speed, b.f, b.invariant.hi()});
        factor_lo = std::min({factor_lo, b.speed, b.f, b.invariant.lo()});
        change_hi = std::max(change_hi, abs(b.change).hi() / unit.size);
    }
    const double margin = 0.08 * (factor_hi - factor_lo);
    if (orbit.behind) {
        change_hi = std::max(change_hi, abs(*orbit.behind).hi() / unit.size);
    }
    change_hi *= 1.12;

    std::vector<LegendEntry> entries{{Swatch::curve, "speed", "|phidot|"},
                                     {Swatch::curve, "f", "f = \xcf\x80 \xe2\x88\x92 arccos y"},
                                     {Swatch::curve, "invariant", "I = |phidot| f"}};
    if (bound) {
        entries.push_back(
            {Swatch::curve, "bound",
             fmt::format("proved for all orbits: {} {}", exact_text(certificate.bounds.front()), unit.word)});
    }
    const double whole_width = page_width - left - right_margin;
    const Legend legend(std::move(entries), whole_width);
    const Frame factors(left, top_margin + legend.height() + 10, whole_width, plot_height,
                        numbers_axis(orbit.bounces.size()),
                        {factor_lo - margin, factor_hi + margin, "relative to the start",
                         even_ticks(factor_lo - margin, factor_hi + margin, 5)});
    const Frame changes(left, factors.bottom() + below_axes, whole_width, plot_height,
                        numbers_axis(orbit.bounces.size()),
                        {-change_hi, change_hi, unit.name, even_ticks(-change_hi, change_hi, 6)});
    const auto caption = broken_lines(caption_of(certificate, orbit), whole_width);
    const double caption_top = changes.bottom() + below_axes;
    Svg svg(page_width, caption_top + caption_step * static_cast<double>(caption.size()),
            "The adiabatic invariant of a bouncing dumbbell along an orbit");
    style(svg);
    legend.draw(svg, left, top_margin);
    draw_factors(svg, factors, orbit);
    draw_changes(svg, changes, orbit, unit.size, bound);
    draw_caption(svg, left, caption_top, caption);
    return svg.finished();
}

}  // namespace dumbbell
