#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "number/rational.hpp"
#include "pictures/svg.hpp"

/// Axes, marks and legends, as all pictures have them.
namespace dumbbell::pictures {

struct Tick {
    double value;
    std::string label;
};

/// How values lie along an axis: evenly, or by their logarithm.
enum class Scale { linear, logarithmic };

struct PlotAxis {
    double lo;
    double hi;
    std::string label;
    std::vector<Tick> ticks;
    Scale scale = Scale::linear;

    /// Where the value lies: 0 at lo, 1 at hi.
    [[nodiscard]] double share(double value) const;
};

/// Marks at round numbers: about `wanted` of them.
[[nodiscard]] std::vector<Tick> even_ticks(double lo, double hi, int wanted);
/// What the numbers along an axis have room for: its length in pixels, and whether it is upright.
struct AxisRoom {
    double length;
    bool upright = false;
};

/// For a logarithmic axis: 1, 2 and 5 of each decade, or even ones where the range holds few of those. Marks
/// whose numbers would run into one another have none (an empty label). 0 < lo < hi.
[[nodiscard]] std::vector<Tick> decade_ticks(double lo, double hi, const AxisRoom& room);
/// Multiples of pi/2 (or of pi, 2 pi, ... where the range holds many).
[[nodiscard]] std::vector<Tick> angle_ticks(double lo, double hi);

/// A rectangle of the page with a horizontal and a vertical axis (upwards).
class Frame {
  public:
    Frame(double left, double top, double width, double height, PlotAxis x, PlotAxis y);

    [[nodiscard]] double x(double value) const { return left_ + width_ * horizontal_.share(value); }
    [[nodiscard]] double y(double value) const { return bottom() - height_ * vertical_.share(value); }
    [[nodiscard]] double left() const { return left_; }
    [[nodiscard]] double top() const { return top_; }
    [[nodiscard]] double right() const { return left_ + width_; }
    [[nodiscard]] double bottom() const { return top_ + height_; }
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }

    /// As a path: the points that `point` gives for 0, 1/200, 2/200, ..., 1.
    [[nodiscard]] std::string curve(const std::function<std::pair<double, double>(double)>& point) const;

    /// The lines in the background of the picture.
    void draw_grid(Svg& svg) const;
    /// Its edge, marks, numbers and names: drawn last.
    void draw_axes(Svg& svg) const;
    /// What follows is cut to the frame, until Svg::close.
    void open_clip(Svg& svg) const { svg.open_clip(left_, top_, width_, height_); }

  private:
    double left_;
    double top_;
    double width_;
    double height_;
    PlotAxis horizontal_;
    PlotAxis vertical_;
};

/// What a line of a legend shows before its words.
enum class Swatch { area, curve, dot, square };

struct LegendEntry {
    Swatch swatch;
    std::string kind;  ///< its class
    std::string words;
};

/// Entries side by side, in as many rows as the width needs.
class Legend {
  public:
    Legend(std::vector<LegendEntry> entries, double width);

    [[nodiscard]] double height() const;
    void draw(Svg& svg, double left, double top) const;

  private:
    struct Place {
        double x;
        int row;
    };
    std::vector<LegendEntry> entries_;
    std::vector<Place> places_;
};

/// Where an exact number is drawn.
inline double value(const Rational& x) { return x.convert_to<double>(); }

/// The page that all pictures share, in pixels.
inline constexpr double page_width = 860;
inline constexpr double right_margin = 32;
inline constexpr double top_margin = 16;

/// Lines of explanation below a picture, broken to a width.
[[nodiscard]] std::vector<std::string> broken_lines(std::string_view text, double width);

/// How far apart such lines are.
inline constexpr double caption_step = 17;

/// Draws them; the first one's base line is at `top`.
void draw_caption(Svg& svg, double left, double top, const std::vector<std::string>& lines);

}  // namespace dumbbell::pictures
