#include "pictures/svg.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/printable.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::pictures {
namespace {

constexpr double letter_width = 7.4;  // of the usual size, on average

constexpr std::string_view light_style =
    "text{font:13px "
    "sans-serif;fill:#222}.head{font-weight:600;font-size:15px}.small{font-size:12px;fill:#59626c}"
    ".page{fill:#fff}.grid{stroke:#e2e5e9}.frame{fill:none;stroke:#8b949e}"
    ".hatched{fill:url(#hatch)}.hatch-ground{fill:#fff}";
constexpr std::string_view dark_style =
    "text{fill:#d9dee4}.small{fill:#9aa4af}.page{fill:#12161c}.grid{stroke:#2a313a}.frame{stroke:#6c7680}"
    ".hatch-ground{fill:#12161c}";

/// What is not decided, or has no value: stripes that no colour is.
constexpr std::string_view hatch =
    R"svg(<defs><pattern id="hatch" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">)svg"
    R"svg(<rect class="hatch-ground" width="6" height="6"/><line class="hatch" x1="0" y1="0" x2="0" y2="6"/></pattern></defs>)svg"
    "\n";

std::string_view attribute(Anchor anchor) {
    return anchor == Anchor::middle ? R"( text-anchor="middle")"
           : anchor == Anchor::end  ? R"( text-anchor="end")"
                                    : "";
}

}  // namespace

std::string px(double length) {
    std::string text = fmt::format("{:.2f}", length);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string xml_text(std::string_view text) {
    return respelled(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

double text_width(std::string_view text) {
    // Of UTF-8.
    const auto is_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return letter_width * static_cast<double>(std::count_if(text.begin(), text.end(), is_letter));
}

Svg::Svg(double width, double height, std::string_view title)
    : head_(fmt::format(
          R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" role="img">)"
          "\n<title>{2}</title>\n",
          px(width), px(height), xml_text(title))),
      light_(fmt::format("{}.hatch{{stroke:{};stroke-width:1.6}}", light_style, palette::hatch.light)),
      dark_(fmt::format("{}.hatch{{stroke:{}}}", dark_style, palette::hatch.dark)) {
    body_ = fmt::format("<rect class=\"page\" width=\"{}\" height=\"{}\"/>\n", px(width), px(height));
}

void Svg::colour(std::string_view kind, std::string_view property, const Shade& shade) {
    light_ += fmt::format(".{}{{{}:{}}}", kind, property, shade.light);
    dark_ += fmt::format(".{}{{{}:{}}}", kind, property, shade.dark);
}

void Svg::rules(std::string_view css) { light_ += css; }

void Svg::line(std::string_view kind, double x1, double y1, double x2, double y2) {
    body_ += fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", kind, px(x1),
                         px(y1), px(x2), px(y2));
}

void Svg::rect(std::string_view kind, double x, double y, double width, double height) {
    body_ += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", kind, px(x),
                         px(y), px(width), px(height));
}

void Svg::circle(std::string_view kind, double x, double y, double radius) {
    body_ +=
        fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", kind, px(x), px(y), px(radius));
}

void Svg::path(std::string_view kind, std::string_view data) {
    body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, data);
}

void Svg::text(double x, double y, std::string_view words, Anchor anchor, std::string_view kind) {
    body_ += fmt::format("<text{} x=\"{}\" y=\"{}\"{}>{}</text>\n",
                         kind.empty() ? "" : fmt::format(" class=\"{}\"", kind), px(x), px(y),
                         attribute(anchor), xml_text(words));
}

void Svg::upright_text(double x, double y, std::string_view words) {
    body_ +=
        fmt::format("<text transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                    px(x), px(y), xml_text(words));
}

void Svg::open_clip(double x, double y, double width, double height) {
    ++clips_;
    body_ += fmt::format(
        "<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
        "<g clip-path=\"url(#clip{0})\">\n",
        clips_, px(x), px(y), px(width), px(height));
}

void Svg::open_units(double x, double y, double x_unit, double y_unit) {
    body_ += fmt::format("<g transform=\"translate({} {}) scale({:.12g} {:.12g})\">\n", px(x), px(y), x_unit,
                         y_unit);
}

void Svg::close() { body_ += "</g>\n"; }

std::string Svg::finished() const {
    const bool is_hatched = body_.find("\"hatched\"") != std::string::npos;
    return fmt::format("{}<style>{}@media (prefers-color-scheme:dark){{{}}}</style>\n{}{}</svg>\n", head_,
                       light_, dark_, is_hatched ? hatch : "", body_);
}

}  // namespace dumbbell::pictures
