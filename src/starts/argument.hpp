#pragma once

#include <string>
#include <utility>

#include "number/rational.hpp"

namespace dumbbell::starts {

/// A or LO:HI of an option like --phi, --y or --delta: exact, with or without a leading minus. Throws
/// InputError that names the option and says how it is written.
[[nodiscard]] std::pair<Rational, Rational> parse_quantity(const std::string& option,
                                                           const std::string& text);

}  // namespace dumbbell::starts
