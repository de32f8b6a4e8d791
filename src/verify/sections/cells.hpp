#pragma once
#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"

namespace dumbbell_verify {

/// Reads a file of the section cells after its line `claim`; returns only if all that the file and the demand
/// say is certified; else throws the Failure of the least line.
Proof proof_by_cells(Text& text, const Settings& settings);

}  // namespace dumbbell_verify
