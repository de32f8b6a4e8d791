#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "number/interval.hpp"
#include "number/rational.hpp"

namespace dumbbell {

/// Numbers cut to a few digits so that what is printed, read as it stands, is still true.

/// The least number of three digits that is not below x >= 0.
[[nodiscard]] std::string rounded_up(const Rational& x);
[[nodiscard]] std::string rounded_up(double x);

/// The greatest number of three digits that is not above x >= 0.
[[nodiscard]] std::string rounded_down(double x);

/// A short decimal and a radius that covers both ends of x from that decimal, e.g. `0.25+-1.0e-14`.
[[nodiscard]] std::string enclosure_text(const Interval& x);

/// x as it is printed: 0 has no sign, whatever the arithmetic gave it.
[[nodiscard]] constexpr double unsigned_zero(double x) { return x == 0 ? 0.0 : x; }

/// What an undecided share leaves, as a number that does not exceed it: 1 only if that is all.
[[nodiscard]] double decided_fraction(const Rational& undecided);

/// "1 piece", "2 pieces".
template <class Number>
[[nodiscard]] std::string plural(const Number& n, std::string_view one) {
    return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s");
}

/// A time for people: 40 s, 12 min, 3.5 h, 2.1 days, 30 years.
[[nodiscard]] std::string time_text(double seconds);

}  // namespace dumbbell
