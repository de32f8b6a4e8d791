#pragma once

#include <limits>
#include <string>

#include "base/error.hpp"
#include "dumbbell/mass_ratio.hpp"
#include "number/rational.hpp"

namespace dumbbell::api {

/// The exact value of MassRatio::lo() or hi(): a number of 2,100 characters can have a longer fraction.
[[nodiscard]] inline Rational exact_ratio(const std::string& fraction) {
    return parse_rational(fraction, std::numeric_limits<std::size_t>::max());
}

/// Throws InputError for a range.
[[nodiscard]] inline Rational single_ratio(const MassRatio& ratio, const std::string& who) {
    if (ratio.lo() != ratio.hi()) {
        throw dumbbell::InputError(who + " takes one mass ratio, not the range " + ratio.lo() + ":" +
                                   ratio.hi());
    }
    return exact_ratio(ratio.lo());
}

}  // namespace dumbbell::api
