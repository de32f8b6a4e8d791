// Files of the claim kind `law` (format-law.md).
#pragma once
#include <span>
#include <utility>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"
#include "verify/wings/law/claim.hpp"

namespace dumbbell_verify::law {

/// Reads on after the line `claim`; returns only if all that the file and the demand say is certified, else
/// throws the Failure of the least line.
std::pair<Proof, Claim> proof(Text& text, const Settings& settings);

/// The kind of these files, for the program.
std::span<const ClaimKind> claim_kinds();

}  // namespace dumbbell_verify::law
