#pragma once

#include "adiabatic/certificate.hpp"
#include "base/interrupted.hpp"

namespace dumbbell::adiabatic {

/// The classes of L35 to try for a run or a scattering, without trees: numbers J that suit the hypotheses,
/// and for each about the least density v that does. In plain doubles: nothing rests on it before a tree
/// proves it. The same whatever the number of threads; none if interrupted.
[[nodiscard]] std::vector<Class> guess_classes(const Hypotheses& of, int jobs = 1,
                                               const Interrupted& interrupted = never);

/// The same class with a density greater by this factor.
[[nodiscard]] Class with_slack(Class one, double slack);

}  // namespace dumbbell::adiabatic
