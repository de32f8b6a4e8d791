#pragma once

#include <string_view>
#include <utility>

#include "number/rational.hpp"

namespace dumbbell::starts {

/// An angle exactly as it is given, radians + pis * pi: one of the two is 0.
struct Angle {
    Rational radians = 0;
    Rational pis = 0;

    [[nodiscard]] bool is_rational() const { return pis == 0; }
    friend bool operator==(const Angle&, const Angle&) = default;
};

/// Radians (`1/3`, `0.5`), degrees (`30deg`) or a multiple of pi (`pi/2`, `2pi/3`, `0.3pi`), with a minus
/// before it or without. Throws InputError (naming the text) for anything else.
[[nodiscard]] Angle parse_angle(std::string_view text);

/// Rational numbers lo <= angle <= hi: twice the angle itself if it is rational, else those of Arb's
/// enclosure of pi, which is proved, with this many bits. Precondition: that of PrecisionScope.
[[nodiscard]] std::pair<Rational, Rational> bounds(const Angle& angle, int bits);

}  // namespace dumbbell::starts
