#include "words/printed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dumbbell {
namespace {

/// The exact value of a number as it is printed, e.g. -1.5e-05.
Rational as_printed(std::string_view text) {
    const bool negative = text.starts_with('-');
    const Rational magnitude = parse_rational(text.substr(negative ? 1 : 0));
    return negative ? -magnitude : magnitude;
}

}  // namespace

std::string rounded_up(double x) {
    const std::string text = fmt::format("{:.3g}", x);
    return as_printed(text) < exact(x) ? fmt::format("{:.3g}", x * 1.005) : text;
}

std::string rounded_down(double x) {
    const std::string text = fmt::format("{:.3g}", x);
    return as_printed(text) > exact(x) ? fmt::format("{:.3g}", x * 0.995) : text;
}

std::string enclosure_text(const Interval& x) {
    const std::string centre = fmt::format("{:.12g}", unsigned_zero(approximate(x)));
    const Rational c = as_printed(centre);
    const double radius = std::abs(enclose<Interval>(std::max(exact(x.hi()) - c, c - exact(x.lo()))).hi());
    return fmt::format("{}+-{:.1e}", centre, radius * 1.06);  // two digits lose at most 1 part in 20
}

double decided_fraction(const Rational& undecided) {
    return undecided == 0 ? 1.0 : enclose<Interval>(Rational(1) - undecided).lo();
}

std::string time_text(double seconds) {
    return seconds < 120         ? fmt::format("{:.0f} s", seconds)
           : seconds < 7200      ? fmt::format("{:.0f} min", seconds / 60)
           : seconds < 48 * 3600 ? fmt::format("{:.1f} h", seconds / 3600)
                                 : fmt::format("{:.1f} days", seconds / 86400);
}

}  // namespace dumbbell
