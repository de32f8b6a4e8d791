#pragma once

#include <functional>

namespace dumbbell {

/// Where the maximum seems to step up to `n` (n >= 3): the critical ratio q_c(n) of theory, in double
/// precision, from the two extremal orbits. A guess that says where to split a range; every claim about the
/// pieces is proved by covers and witnesses, and every critical ratio by its own enclosure (critical.hpp). A
/// meaningless number if it is interrupted.
[[nodiscard]] double guess_critical_ratio(
    long n, const std::function<bool()>& interrupted = [] { return false; });

/// What the maximum seems to be at q >= 1: a guess, wrong near critical ratios.
[[nodiscard]] long guess_maximum(double q);

}  // namespace dumbbell
