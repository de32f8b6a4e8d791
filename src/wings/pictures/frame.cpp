#include "pictures/frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dumbbell::pictures {
namespace {

constexpr double tolerance = 1e-9;  // of a range: a mark at its end is in it
constexpr double swatch_width = 26;
constexpr double swatch_gap = 7;
constexpr double entry_gap = 22;
constexpr double row_height = 20;

double position(Scale scale, double value) { return scale == Scale::logarithmic ? std::log10(value) : value; }

/// The least of 1, 2, 5 times a power of ten that is at least x.
double round_number(double x) {
    const double power = std::pow(10, std::floor(std::log10(x)));
    for (const double m : {1.0, 2.0, 5.0}) {
        if (m * power >= x * (1 - tolerance)) {
            return m * power;
        }
    }
    return 10 * power;
}

constexpr std::string_view minus = "\xe2\x88\x92";

std::string angle_label(long halves) {
    const std::string_view sign = halves < 0 ? minus : "";
    const long n = std::labs(halves);
    if (n == 0) {
        return "0";
    }
    const long times = n % 2 == 0 ? n / 2 : n;
    return fmt::format("{}{}\xcf\x80{}", sign, times == 1 ? "" : std::to_string(times),
                       n % 2 == 0 ? "" : "/2");
}

/// A number with true minus signs, and its exponent as people write it: 6e-6.
std::string number_label(double value, int digits = 10) {
    std::string text = fmt::format("{:.{}g}", std::abs(value), digits);
    if (const std::size_t e = text.find('e'); e != std::string::npos) {
        const int exponent = std::stoi(text.substr(e + 1));
        text = fmt::format("{}e{}{}", text.substr(0, e), exponent < 0 ? minus : "", std::abs(exponent));
    }
    return value < 0 ? std::string(minus) + text : text;
}

/// Do the numbers of these marks keep apart on a logarithmic axis?
bool keep_apart(const std::vector<Tick>& ticks, const PlotAxis& axis, const AxisRoom& room) {
    constexpr double apart = 10;  // pixels between numbers
    constexpr double line = 17;
    const Tick* before = nullptr;
    for (const Tick& tick : ticks) {
        if (tick.label.empty()) {
            continue;
        }
        if (before != nullptr) {
            const double distance = (axis.share(tick.value) - axis.share(before->value)) * room.length;
            const double needed =
                room.upright ? line : (text_width(before->label) + text_width(tick.label)) / 2 + apart;
            if (distance < needed) {
                return false;
            }
        }
        before = &tick;
    }
    return true;
}

}  // namespace

double PlotAxis::share(double value) const {
    const double from = position(scale, lo);
    return (position(scale, value) - from) / (position(scale, hi) - from);
}

std::vector<Tick> even_ticks(double lo, double hi, int wanted) {
    constexpr int usual_digits = 10;
    constexpr int most_digits = 15;
    const double step = round_number((hi - lo) / wanted);
    const double slack = (hi - lo) * tolerance;
    const double needed = std::ceil(std::log10(std::max(std::abs(lo), std::abs(hi)) / step)) + 1;
    const int digits = static_cast<int>(std::clamp<double>(needed, usual_digits, most_digits));
    std::vector<Tick> ticks;
    for (double i = std::ceil((lo - slack) / step); i * step <= hi + slack; ++i) {
        ticks.push_back({i * step, number_label(i == 0 ? 0 : i * step, digits)});
    }
    return ticks;
}

std::vector<Tick> decade_ticks(double lo, double hi, const AxisRoom& room) {
    const PlotAxis axis{lo, hi, "", {}, Scale::logarithmic};
    std::vector<Tick> ticks;
    const auto first = static_cast<int>(std::floor(std::log10(lo)));
    const auto last = static_cast<int>(std::floor(std::log10(hi)));
    for (int decade = first; decade <= last; ++decade) {
        for (const double m : {1.0, 2.0, 5.0}) {
            const double value = m * std::pow(10, decade);
            if (value >= lo * (1 - tolerance) && value <= hi * (1 + tolerance)) {
                ticks.push_back({value, number_label(value)});
            }
        }
    }
    constexpr std::size_t few = 4;
    if (ticks.size() < few) {
        int wanted = 6;
        for (ticks = even_ticks(lo, hi, wanted); wanted > 2 && !keep_apart(ticks, axis, room); --wanted) {
            ticks = even_ticks(lo, hi, wanted - 1);
        }
        return ticks;
    }
    for (int every = 1; !keep_apart(ticks, axis, room) && every <= last - first + 1; ++every) {
        for (Tick& tick : ticks) {  // numbers at every such power of ten
            const double decade = std::log10(tick.value);
            const bool is_power = std::abs(decade - std::round(decade)) < tolerance;
            if (!is_power || std::lround(decade) % every != 0) {
                tick.label.clear();
            }
        }
    }
    return ticks;
}

std::vector<Tick> angle_ticks(double lo, double hi) {
    constexpr double quarter = std::numbers::pi / 2;
    constexpr double most = 9;
    long step = 1;
    while ((hi - lo) / (quarter * static_cast<double>(step)) > most) {
        step *= 2;
    }
    std::vector<Tick> ticks;
    const double unit = quarter * static_cast<double>(step);
    const double slack = (hi - lo) * tolerance;
    for (double i = std::ceil((lo - slack) / unit); i * unit <= hi + slack; ++i) {
        ticks.push_back({i * unit, angle_label(std::lround(i) * step)});
    }
    constexpr std::size_t few = 2;
    return ticks.size() < few ? even_ticks(lo, hi, 6) : ticks;
}

Frame::Frame(double left, double top, double width, double height, PlotAxis x, PlotAxis y)
    : left_(left),
      top_(top),
      width_(width),
      height_(height),
      horizontal_(std::move(x)),
      vertical_(std::move(y)) {}

std::string Frame::curve(const std::function<std::pair<double, double>(double)>& point) const {
    constexpr int parts = 200;
    std::string path;
    for (int i = 0; i <= parts; ++i) {
        const auto [at_x, at_y] = point(static_cast<double>(i) / parts);
        path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', x(at_x), y(at_y));
    }
    return path;
}

void Frame::draw_grid(Svg& svg) const {
    for (const Tick& tick : horizontal_.ticks) {
        svg.line("grid", x(tick.value), top_, x(tick.value), bottom());
    }
    for (const Tick& tick : vertical_.ticks) {
        svg.line("grid", left_, y(tick.value), right(), y(tick.value));
    }
}

void Frame::draw_axes(Svg& svg) const {
    constexpr double tick_length = 4;
    svg.rect("frame", left_, top_, width_, height_);
    double number_width = 0;
    for (const Tick& tick : horizontal_.ticks) {
        svg.line("frame", x(tick.value), bottom(), x(tick.value), bottom() + tick_length);
        if (!tick.label.empty()) {
            svg.text(x(tick.value), bottom() + 19, tick.label, Anchor::middle);
        }
    }
    for (const Tick& tick : vertical_.ticks) {
        svg.line("frame", left_ - tick_length, y(tick.value), left_, y(tick.value));
        if (!tick.label.empty()) {
            svg.text(left_ - 8, y(tick.value) + 4.5, tick.label, Anchor::end);
        }
        number_width = std::max(number_width, text_width(tick.label));
    }
    svg.text(left_ + width_ / 2, bottom() + 40, horizontal_.label, Anchor::middle);
    svg.upright_text(left_ - 20 - number_width, top_ + height_ / 2, vertical_.label);
}

Legend::Legend(std::vector<LegendEntry> entries, double width) : entries_(std::move(entries)) {
    double x = 0;
    int row = 0;
    for (const LegendEntry& entry : entries_) {
        const double length = swatch_width + swatch_gap + text_width(entry.words);
        if (x > 0 && x + length > width) {
            x = 0;
            ++row;
        }
        places_.push_back({x, row});
        x += length + entry_gap;
    }
}

double Legend::height() const { return places_.empty() ? 0 : row_height * (places_.back().row + 1); }

void Legend::draw(Svg& svg, double left, double top) const {
    constexpr double area_height = 12;
    constexpr double dot_radius = 4.5;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const auto& [swatch, kind, words] = entries_[i];
        const double x = left + places_[i].x;
        const double middle = top + row_height * (places_[i].row + 0.5);
        switch (swatch) {
            case Swatch::area:
                svg.rect(kind, x, middle - area_height / 2, swatch_width, area_height);
                svg.rect("frame", x, middle - area_height / 2, swatch_width, area_height);
                break;
            case Swatch::curve:
                svg.line(kind, x, middle, x + swatch_width, middle);
                break;
            case Swatch::dot:
                svg.circle(kind, x + swatch_width / 2, middle, dot_radius);
                break;
            case Swatch::square:
                svg.rect(kind, x + swatch_width / 2 - dot_radius, middle - dot_radius, 2 * dot_radius,
                         2 * dot_radius);
                break;
        }
        svg.text(x + swatch_width + swatch_gap, middle + 4.5, words);
    }
}

std::vector<std::string> broken_lines(std::string_view text, double width) {
    constexpr double small_share = 12.0 / 13;  // captions are a little smaller than other text
    std::vector<std::string> lines(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        std::string& line = lines.back();
        if (line.empty()) {
            line = word;
        } else if (small_share * text_width(fmt::format("{} {}", line, word)) <= width) {
            line += fmt::format(" {}", word);
        } else {
            lines.emplace_back(word);
        }
    }
    return lines;
}

void draw_caption(Svg& svg, double left, double top, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        svg.text(left, top, line, Anchor::start, "small");
        top += caption_step;
    }
}

}  // namespace dumbbell::pictures
