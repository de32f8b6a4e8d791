#include "words/printed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "number/decimal.hpp"

namespace dumbbell {
namespace {

/// A number of three digits as `{:.3g}` writes it, beyond the doubles, too.
std::string three_digits(const Decimal& x) {
    const int digits = x.mantissa.convert_to<int>(), exponent = x.exponent + 2;
    return exponent < -4 || exponent > 2 ? fmt::format("{:.3g}e{:+03d}", digits / 100.0, exponent)
                                         : fmt::format("{:.3g}", digits / std::pow(10, -x.exponent));
}

}  // namespace

std::string rounded_up(const Rational& x) { return three_digits(cut_up(x, 3)); }

std::string rounded_up(double x) { return rounded_up(exact(x)); }

std::string rounded_down(double x) { return x == 0 ? "0" : three_digits(cut_down(exact(x), 3)); }

std::string enclosure_text(const Interval& x) {
    const std::string centre = fmt::format("{:.12g}", unsigned_zero(approximate(x)));
    const Rational c = parse_signed_rational(centre);
    const double radius = std::abs(enclose<Interval>(std::max(exact(x.hi()) - c, c - exact(x.lo()))).hi());
    return fmt::format("{}+-{:.1e}", centre, radius * 1.06);  // two digits lose at most 1 part in 20
}

double decided_fraction(const Rational& undecided) {
    return undecided == 0 ? 1.0 : enclose<Interval>(Rational(1) - undecided).lo();
}

std::string time_text(double seconds) {
    constexpr double day = 86400;
    return seconds < 120         ? fmt::format("{:.0f} s", seconds)
           : seconds < 7200      ? fmt::format("{:.0f} min", seconds / 60)
           : seconds < 48 * 3600 ? fmt::format("{:.1f} h", seconds / 3600)
           : seconds < 730 * day ? fmt::format("{:.1f} days", seconds / day)
                                 : fmt::format("{:.3g} years", seconds / (365.25 * day));
}

}  // namespace dumbbell
