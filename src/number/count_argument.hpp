#pragma once

#include <string>
#include <utility>

namespace dumbbell {

/// Orbits with more collisions are not followed.
inline constexpr long greatest_count = 100'000'000'000'000'000;

/// N or N1:N2, numbers of collisions with a critical ratio: 3 <= N1 <= N2, not too many. Throws InputError.
[[nodiscard]] std::pair<long, long> parse_counts(const std::string& text);

}  // namespace dumbbell
