#pragma once

#include "api/checked.hpp"
#include "api/exact_ratio.hpp"
#include "dumbbell/trace.hpp"
#include "starts/given/given_start.hpp"

namespace dumbbell::api {

/// A caller's precision; 0 is double precision. Throws InputError.
inline int checked_digits(int digits) { return checked("digits", digits, 0, 100'000); }

/// The box that is meant. Throws InputError, naming the quantity.
inline starts::Box start_of(const MassRatio& ratio, const InitialCondition& start, int bits) {
    return starts::read_start({.phi = start.phi, .phidot = start.phidot, .y = start.y, .ydot = start.ydot},
                              exact_ratio(ratio.lo()), exact_ratio(ratio.hi()), "", bits)
        .box;
}

}  // namespace dumbbell::api
