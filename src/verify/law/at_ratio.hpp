// Files of the claim kind `collisions-by-law` (format-law.md, section 5).
#pragma once
#include <utility>

#include "verify/format/proof.hpp"
#include "verify/format/text.hpp"
#include "verify/law/claim.hpp"

namespace dumbbell_verify {

/// Reads on after the line `claim`; returns only if all that the file, the law's file and the demand say is
/// certified, else throws the Failure of the least line.
std::pair<Proof, LawAtRatio> law_at_ratio(Text& text, const Settings& settings);

}  // namespace dumbbell_verify
