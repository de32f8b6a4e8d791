#pragma once

#include "api/exact_ratio.hpp"
#include "base/error.hpp"
#include "dumbbell/mass_ratio.hpp"

namespace dumbbell::api {

/// Throws InputError for a range.
[[nodiscard]] inline Rational single_ratio(const MassRatio& ratio, const std::string& who) {
    if (ratio.lo() != ratio.hi()) {
        throw dumbbell::InputError(who + " takes one mass ratio, not the range " + ratio.lo() + ":" +
                                   ratio.hi());
    }
    return exact_ratio(ratio.lo());
}

}  // namespace dumbbell::api
