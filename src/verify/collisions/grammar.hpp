// Files of the claim kind `collisions` (format.md, section 3).
#pragma once
#include "verify/format/proof.hpp"
#include "verify/format/section.hpp"
#include "verify/format/text.hpp"

namespace dumbbell_verify {

/// Reads on after the line `claim`; returns only if all that the file and the demand say is certified; else
/// throws the Failure of the least line.
Proof collisions(Text& text, const Settings& settings, const Section& section);

}  // namespace dumbbell_verify
