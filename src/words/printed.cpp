#include "words/printed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dumbbell {
namespace {

/// A number of three digits: digits * 10^(exponent - 2), its digits from 100 to 999, or 0.
struct ThreeDigits {
    int digits;
    int exponent;

    [[nodiscard]] Rational value() const {
        return parse_rational(fmt::format("{}e{}", digits, exponent - 2));
    }
    [[nodiscard]] ThreeDigits next() const {
        return digits == 999 ? ThreeDigits{100, exponent + 1} : ThreeDigits{digits + 1, exponent};
    }
    [[nodiscard]] ThreeDigits before() const {
        return digits == 100 ? ThreeDigits{999, exponent - 1} : ThreeDigits{digits - 1, exponent};
    }
    /// As `{:.3g}` writes it.
    [[nodiscard]] std::string text() const {
        return exponent < -4 || exponent > 2 ? fmt::format("{:.3g}e{:+03d}", digits / 100.0, exponent)
                                             : fmt::format("{:.3g}", digits / std::pow(10, 2 - exponent));
    }
};

ThreeDigits nearest(double x) {
    const std::string text = fmt::format("{:.2e}", x);  // 4.32e-40
    return {std::stoi(text.substr(0, 1) + text.substr(2, 2)), std::stoi(text.substr(5))};
}

}  // namespace

std::string rounded_up(const Rational& x) {
    const ThreeDigits near = nearest(enclose<Interval>(x).hi());
    return (near.value() < x ? near.next() : near).text();
}

std::string rounded_up(double x) { return rounded_up(exact(x)); }

std::string rounded_down(double x) {
    const ThreeDigits near = nearest(x);
    return (near.value() > exact(x) ? near.before() : near).text();
}

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
