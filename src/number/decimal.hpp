#pragma once

#include <optional>
#include <string>

#include "number/rational.hpp"

namespace dumbbell {

/// The exact number mantissa * 10^exponent, mantissa >= 0: what a printed decimal means.
struct Decimal {
    Integer mantissa;
    int exponent = 0;

    friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// x > 0 with `digits` >= 1 significant digits, towards 0: its first digits as they are, not rounded.
[[nodiscard]] Decimal cut_down(const Rational& x, int digits);

/// The least decimal with `digits` significant digits that is at least x; x >= 0.
[[nodiscard]] Decimal cut_up(const Rational& x, int digits);

/// The first `digits` significant digits that all numbers of [lo, hi] share, 0 < lo <= hi; nothing if they
/// do not share them. So every digit of the result is one of every number in between.
[[nodiscard]] std::optional<Decimal> shared_digits(const Rational& lo, const Rational& hi, int digits);

[[nodiscard]] Rational exact(const Decimal& x);

/// All digits of the mantissa, e.g. `4.6030`, `12`, `0.0310`, `1.03e6`, `3.8e-15`: what parse_rational reads
/// as exactly x.
[[nodiscard]] std::string to_text(const Decimal& x);

/// The same without zeros at its end: for numbers that are exactly x.
[[nodiscard]] Decimal without_zeros(Decimal x);

/// Exactly x > 0, for people: `4.6`, `1.000000000000000000000000000001`, `10/3`, `1e300`. A decimal, unless x
/// has none, or one of more than 17 digits that is longer than the fraction. So different numbers never look
/// alike, and parse_rational reads the text as x.
[[nodiscard]] std::string exact_text(const Rational& x);
/// The same for any x.
[[nodiscard]] std::string spelled(const Rational& x);
/// The same, `LO:HI`, as an option takes it; one number if there is only one.
[[nodiscard]] std::string spelled(const Rational& lo, const Rational& hi);

}  // namespace dumbbell
