#pragma once

#include "base/interrupted.hpp"

namespace dumbbell::collisions {

/// Where the maximum seems to step up to `n` (n >= 3): the critical ratio q_c(n) of theory, in double
/// precision, from the two extremal orbits. A guess that says where to split a range; every claim about the
/// pieces is proved by covers and witnesses. A meaningless number if it is interrupted.
[[nodiscard]] double guess_step(long n, const Interrupted& interrupted = never);

/// What the maximum seems to be at q >= 1: a guess, wrong near critical ratios and if it is interrupted.
[[nodiscard]] long guess_maximum(double q, const Interrupted& interrupted = never);

}  // namespace dumbbell::collisions
