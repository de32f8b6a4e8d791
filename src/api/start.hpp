#pragma once

#include "api/exact_ratio.hpp"
#include "base/error.hpp"
#include "dumbbell/trace.hpp"
#include "starts/given/given_start.hpp"

namespace dumbbell::api {

/// A caller's precision. Throws InputError.
inline int checked_digits(int digits) {
    if (digits < 0 || digits > 100'000) {
        throw dumbbell::InputError("digits is out of range: give 0 (double precision) to 100000");
    }
    return digits;
}

/// The box that is meant. Throws InputError, naming the quantity.
inline starts::Box start_of(const MassRatio& ratio, const InitialCondition& start, int bits) {
    return starts::read_start({.phi = start.phi, .phidot = start.phidot, .y = start.y, .ydot = start.ydot},
                              exact_ratio(ratio.lo()), exact_ratio(ratio.hi()), "", bits)
        .box;
}

}  // namespace dumbbell::api
