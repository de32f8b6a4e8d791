#pragma once

#include <optional>

#include "collisions/critical.hpp"

namespace dumbbell::staircase {

/// What cover and witness say of the maximum at one ratio.
struct Decided {
    Rational q;
    long expected = 0;  ///< by Theorem 2
    std::optional<long> upper;
    long lower = 0;
    int bits = 0;

    [[nodiscard]] bool holds() const { return upper == expected && lower == expected; }
};

/// That the maximum is n - 1 just below q_c(n) and n just above, proved without Theorem 2.
struct Confirmation {
    Decided below;
    Decided above;

    [[nodiscard]] bool holds() const { return below.holds() && above.holds(); }
};

/// At q_c (1 - distance), rounded down, but at 1 for n = 3 (below 1 the masses are only renamed), and q_c (1
/// + distance), rounded up; by at most a hundredth of the distance, to short decimals. Precondition: 0 <
/// distance <= 0.01, and the enclosure shares digits_to_confirm(distance) digits.
[[nodiscard]] Confirmation confirm(const collisions::CriticalRatio& critical, const Rational& distance,
                                   const Interrupted& interrupted);

/// Digits of q_c with which its enclosure is narrow against the distance.
[[nodiscard]] int digits_to_confirm(const Rational& distance);

}  // namespace dumbbell::staircase
