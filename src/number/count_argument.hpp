#pragma once

#include <string>
#include <utility>

namespace dumbbell {

/// N or N1:N2, numbers of collisions with a critical ratio: 3 <= N1 <= N2. Throws InputError.
[[nodiscard]] std::pair<long, long> parse_counts(const std::string& text);

}  // namespace dumbbell
