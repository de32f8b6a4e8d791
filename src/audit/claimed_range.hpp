#pragma once

#include <string>
#include <utility>

#include "number/rational.hpp"

namespace dumbbell::audit {

/// The mass ratios LO, HI of the line `ratio LO HI` in a certificate's head (format.md, section 2).
/// Throws InputError if the file has none.
[[nodiscard]] std::pair<Rational, Rational> claimed_range(const std::string& path);

}  // namespace dumbbell::audit
