#include "report/staircase_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <vector>

#include "arith/error.hpp"
#include "model/growth_constant.hpp"
#include "model/paper_bound.hpp"

namespace dumbbell {
namespace {

constexpr double page_width = 860;
constexpr double page_height = 480;
constexpr double left = 64;
constexpr double right = 24;
constexpr double top = 44;
constexpr double bottom = 56;

/// The picture's axes: log q to the right, counts upwards.
struct Axes {
    double log_lo, log_hi, count_hi;

    [[nodiscard]] double x(double q) const {
        return left + (std::log10(q) - log_lo) / (log_hi - log_lo) * (page_width - left - right);
    }
    [[nodiscard]] double y(double count) const {
        return page_height - bottom - count / count_hi * (page_height - top - bottom);
    }
};

double value(const Rational& q) { return q.convert_to<double>(); }

/// A round distance between tick marks, for about `wanted` of them.
double tick_step(double range, int wanted) {
    const double raw = range / wanted;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    for (const double m : {1.0, 2.0, 5.0}) {
        if (m * power >= raw) {
            return m * power;
        }
    }
    return 10 * power;
}

/// Ratios to mark: 1, 2 and 5 of each decade, or equal steps where the range holds few of those.
std::vector<double> ratio_ticks(const Axes& axes) {
    std::vector<double> ticks;
    for (double decade = std::floor(axes.log_lo); decade <= axes.log_hi; ++decade) {
        for (const double m : {1.0, 2.0, 5.0}) {
            ticks.push_back(m * std::pow(10, decade));
        }
    }
    const auto is_outside = [&](double q) {
        return std::log10(q) < axes.log_lo - 1e-9 || std::log10(q) > axes.log_hi + 1e-9;
    };
    std::erase_if(ticks, is_outside);
    if (ticks.size() < 4) {
        const double lo = std::pow(10, axes.log_lo);
        const double hi = std::pow(10, axes.log_hi);
        const double step = tick_step(hi - lo, 6);
        ticks.clear();
        for (double i = std::ceil(lo / step); i * step <= hi * (1 + 1e-12); ++i) {
            ticks.push_back(i * step);
        }
    }
    return ticks;
}

void draw_frame(std::string& svg, const Axes& axes) {
    auto out = std::back_inserter(svg);
    const double step = std::max(1.0, tick_step(axes.count_hi, 8));
    for (double n = 0; n <= axes.count_hi; n += step) {
        fmt::format_to(out, R"(<line x1="{0:.1f}" x2="{1:.1f}" y1="{2:.1f}" y2="{2:.1f}" class="grid"/>)",
                       left, page_width - right, axes.y(n));
        fmt::format_to(out, R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{:g}</text>)", left - 8,
                       axes.y(n) + 4, n);
        svg += '\n';
    }
    for (const double q : ratio_ticks(axes)) {
        fmt::format_to(out, R"(<line x1="{0:.1f}" x2="{0:.1f}" y1="{1:.1f}" y2="{2:.1f}" class="grid"/>)",
                       axes.x(q), top, page_height - bottom);
        fmt::format_to(out, R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{:.10g}</text>)", axes.x(q),
                       page_height - bottom + 18, q);
        svg += '\n';
    }
    fmt::format_to(
        out, R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">mass ratio q (heavy over light)</text>)",
        (left + page_width - right) / 2, page_height - 14);
    fmt::format_to(
        out,
        R"svg(<text transform="translate(18 {:.1f}) rotate(-90)" text-anchor="middle">collisions</text>)svg",
        (top + page_height - bottom) / 2);
    svg += '\n';
}

/// ceil(pi / gamma) + 1 steps from m to m + 1 behind q = cot^2(pi / 2m).
std::string paper_path(const Axes& axes, const Rational& q_lo, const Rational& q_hi) {
    long bound = paper_bound(q_lo);
    const long last = paper_bound(q_hi);
    std::string path = fmt::format("M{:.2f} {:.2f}", axes.x(value(q_lo)), axes.y(static_cast<double>(bound)));
    for (; bound < last; ++bound) {
        const double t = std::tan(std::numbers::pi / (2 * static_cast<double>(bound - 1)));
        fmt::format_to(std::back_inserter(path), "H{:.2f}V{:.2f}", axes.x(1 / (t * t)),
                       axes.y(static_cast<double>(bound + 1)));
    }
    return path + fmt::format("H{:.2f}", axes.x(value(q_hi)));
}

/// 2 + C sqrt q, which the maximum stays close to (theorem 4).
std::string growth_path(const Axes& axes) {
    const double c = approximate(growth_constant());
    std::string path;
    constexpr int parts = 200;
    for (int i = 0; i <= parts; ++i) {
        const double q = std::pow(10, axes.log_lo + (axes.log_hi - axes.log_lo) * i / parts);
        fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', axes.x(q),
                       axes.y(2 + c * std::sqrt(q)));
    }
    return path;
}

/// The proved values: exact pieces as treads, gaps as risers at their middle.
std::string proved_path(const Axes& axes, const std::vector<Piece>& pieces) {
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
        const double y = axes.y(static_cast<double>(*piece.upper));
        const double x = axes.x(value(piece.q_lo));
        path += pen_down ? fmt::format("H{:.2f}V{:.2f}", x, y) : fmt::format("M{:.2f} {:.2f}", x, y);
        path += fmt::format("H{:.2f}", axes.x(value(piece.q_hi)));
        pen_down = true;
    }
    return path;
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

/// A curve and its line in the legend, which begins at x.
void draw_curve(std::string& svg, const char* kind, const std::string& path, double x,
                std::string_view name) {
    constexpr double sample = 36;
    fmt::format_to(std::back_inserter(svg),
                   "<path class=\"{0}\" d=\"{1}\"/>\n<line class=\"{0}\" x1=\"{2:g}\" x2=\"{3:g}\" y1=\"22\" "
                   "y2=\"22\"/><text x=\"{4:g}\" y=\"26\">{5}</text>\n",
                   kind, path, x, x + sample, x + sample + 8, name);
}

}  // namespace

std::string staircase_svg(const std::vector<Piece>& pieces, Scene scene) {
    require(!pieces.empty() && pieces.front().q_lo < pieces.back().q_hi, "staircase picture: an empty range");
    const Rational& q_lo = pieces.front().q_lo;
    const Rational& q_hi = pieces.back().q_hi;
    const Axes axes{std::log10(value(q_lo)), std::log10(value(q_hi)),
                    static_cast<double>(greatest_count(pieces, scene)) * 1.04};
    const Names names = names_of(scene);

    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:g} {1:g}" width="{0:g}" height="{1:g}" role="img">)"
        "\n<title>{2}</title>\n"
        "<style>text{{font:13px sans-serif;fill:#222}}.grid{{stroke:#ddd;stroke-width:1}}"
        ".proved{{fill:none;stroke:#0055a4;stroke-width:2.5}}.paper{{fill:none;stroke:#c8501e;stroke-width:1."
        "5;stroke-dasharray:6 4}}.growth{{fill:none;stroke:#333;stroke-width:1;stroke-dasharray:2 3}}"
        "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        page_width, page_height, names.title);
    draw_frame(svg, axes);
    for (const Piece& piece : pieces) {
        if (piece.status() == Status::open) {
            fmt::format_to(std::back_inserter(svg),
                           R"(<rect x="{:.2f}" y="{:.1f}" width="{:.2f}" height="{:.1f}" fill="#eee"/>)",
                           axes.x(value(piece.q_lo)), top,
                           axes.x(value(piece.q_hi)) - axes.x(value(piece.q_lo)), page_height - top - bottom);
            svg += '\n';
        }
    }
    if (scene == Scene::dumbbell) {  // the bound and the growth are the dumbbell's
        draw_curve(svg, "paper", paper_path(axes, q_lo, q_hi), left + 230,
                   "the paper's bound ceil(\xcf\x80/\xce\xb3)+1");
    }
    draw_curve(svg, "proved", proved_path(axes, pieces), left, names.maximum);
    if (scene == Scene::dumbbell) {
        draw_curve(svg, "growth", growth_path(axes), left + 500, "2 + C \xe2\x88\x9aq");
    }
    svg += "</svg>\n";
    return svg;
}

}  // namespace dumbbell
