#pragma once

#include <string>
#include <string_view>

/// Pictures as SVG text, the one way in which all of them are written: elements with classes, one style sheet
/// with colours for light and for dark pages, text as text in the reader's own fonts. The same calls give the
/// same bytes. Lengths are pixels, x to the right and y downwards.
namespace dumbbell::pictures {

/// A length as it stands in a picture: two decimals at most, none of them a zero at the end.
[[nodiscard]] std::string px(double length);

/// The text with &, <, > and " spelled as XML wants them.
[[nodiscard]] std::string xml_text(std::string_view text);

/// About how long a line of text of the usual size is.
[[nodiscard]] double text_width(std::string_view text);

enum class Anchor { start, middle, end };

/// A colour on light and on dark pages.
struct Shade {
    std::string_view light;
    std::string_view dark;
};

class Svg {
  public:
    /// An empty page; the title is what screen readers say.
    Svg(double width, double height, std::string_view title);

    /// Rules of its own for a class: `.kind{property:colour}` in both schemes.
    void colour(std::string_view kind, std::string_view property, const Shade& shade);
    /// Rules that hold in both schemes.
    void rules(std::string_view css);

    void line(std::string_view kind, double x1, double y1, double x2, double y2);
    void rect(std::string_view kind, double x, double y, double width, double height);
    void circle(std::string_view kind, double x, double y, double radius);
    /// `data` in the page's coordinates.
    void path(std::string_view kind, std::string_view data);
    /// `kind` may be empty: plain text.
    void text(double x, double y, std::string_view words, Anchor anchor = Anchor::start,
              std::string_view kind = {});
    /// Read from below.
    void upright_text(double x, double y, std::string_view words);

    /// What follows is cut to the rectangle, until `close`.
    void open_clip(double x, double y, double width, double height);
    /// What follows has coordinates of its own: their point (0, 0) and their units, in pixels.
    void open_units(double x, double y, double x_unit, double y_unit);
    void close();

    [[nodiscard]] std::string finished() const;

  private:
    std::string head_;
    std::string light_;
    std::string dark_;
    std::string body_;
    int clips_ = 0;
};

}  // namespace dumbbell::pictures
