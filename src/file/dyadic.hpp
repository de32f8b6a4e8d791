#pragma once

#include <string>

#include "number/rational.hpp"

namespace dumbbell {

/// Of a coordinate in a file: 2^-4096 is the least place, and 2^4096 the greatest, that it can spell.
inline constexpr int most_binary_places = 4096;

/// odd * 2^places, `odd` odd; or 0 * 2^0.
struct Dyadic {
    Integer odd;
    long places = 0;
};
/// Precondition: the denominator is a power of two.
[[nodiscard]] Dyadic dyadic(const Rational& x);

/// `MbK` for M * 2^K, M odd or 0 (format.md, section 1). Precondition: the denominator is a power of
/// two, at most 2^4096.
[[nodiscard]] std::string to_dyadic(const Rational& x);

}  // namespace dumbbell
