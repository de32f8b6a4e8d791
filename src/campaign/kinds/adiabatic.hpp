#pragma once

#include "adiabatic/certificate.hpp"
#include "campaign/kind.hpp"

namespace dumbbell::campaign {

/// Constants of the adiabatic invariant for a grid of hypotheses: what `dumbbell adiabatic` proves. A unit is
/// one statement, a shard of its own, and a result the certificate that `adiabatic --out` writes. One file
/// proves one statement, so they merge to a table of the statements, which names the file of each.
[[nodiscard]] const Kind& adiabatic_kind();

/// A shard for each statement of a grid, which are all of one claim. Throws InputError if there is only one,
/// or one twice. Preconditions: require_sensible for each; 0 < accuracy <= 1.
[[nodiscard]] Plan plan_adiabatic(const std::vector<adiabatic::AdiabaticHypotheses>& grid,
                                  const Rational& accuracy);

}  // namespace dumbbell::campaign
