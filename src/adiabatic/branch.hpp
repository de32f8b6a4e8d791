#pragma once

#include "adiabatic/certificate.hpp"

namespace dumbbell::adiabatic {

/// By how much (5) of Lemma 3.1 as printed is wrong for phidot_- > 0 at this state (L38 (c)): a lower bound,
/// over epsilon/delta = delta.
[[nodiscard]] double printed_branch_error(const AdiabaticState& state);

}  // namespace dumbbell::adiabatic
