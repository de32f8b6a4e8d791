#pragma once

#include <limits>
#include <string>

#include "number/rational.hpp"

namespace dumbbell::api {

/// The exact value of MassRatio::lo() or hi(): a number of 2,100 characters can have a longer fraction.
[[nodiscard]] inline Rational exact_ratio(const std::string& fraction) {
    return parse_rational(fraction, std::numeric_limits<std::size_t>::max());
}

}  // namespace dumbbell::api
