#pragma once

#include <string>
#include <utility>

#include "number/rational.hpp"
#include "starts/given/angle.hpp"

namespace dumbbell::starts {

/// A or LO:HI of an option like --y or --delta: exact, with or without a leading minus. Throws InputError
/// that names the option and says how it is written; also if LO > HI.
[[nodiscard]] std::pair<Rational, Rational> parse_quantity(const std::string& option,
                                                           const std::string& text);

/// The same of an option like --phi, whose ends are angles.
[[nodiscard]] std::pair<Angle, Angle> parse_angles(const std::string& option, const std::string& text);

}  // namespace dumbbell::starts
