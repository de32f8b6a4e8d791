#pragma once

#include "cli/options/given.hpp"

namespace dumbbell::cli {

/// Whether --rho is a range: a rectangle of bodies is asked for.
[[nodiscard]] bool is_rectangle(const Given& given);

/// `certify --rho LO:HI --inertia LO:HI` (lemma L87). Returns the exit code; throws InputError.
int certify_rectangle(const Given& given);

}  // namespace dumbbell::cli
