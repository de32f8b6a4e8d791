#pragma once

#include <string>

#include "collisions/critical.hpp"

namespace dumbbell::staircase {

/// A critical ratio as it is printed: its first digits, cut off, each of which is a digit of q_c, and a bound
/// of the distance from the number as printed to q_c. So neither depends on how much narrower the proved
/// enclosure is.
struct CriticalNumber {
    std::string value;
    std::string radius;
    bool exact;
};

/// With `digits` significant digits. Throws BrokenInvariant if the enclosure does not decide them.
[[nodiscard]] CriticalNumber critical_number(const collisions::CriticalRatio& ratio, int digits);

/// The orbit whose flight is tangent at q_c(n): `top` or `corner`.
[[nodiscard]] const char* orbit_name(long n);

}  // namespace dumbbell::staircase
