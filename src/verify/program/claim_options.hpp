// The options that state a claim, the same on the command line and in a list of claims.
#pragma once
#include "verify/program/verify.hpp"
#include "verify/program/words.hpp"

namespace dumbbell_verify {

/// Puts the present option into the settings if it is one of --ratio, --max, --min, --exactly, --scene and
/// --claim; false if it is another. Throws std::invalid_argument.
bool claim_option(Words& words, Settings& settings);

/// What was demanded, for a reader: ` ratio=LO:HI max=N min=N`, without what was not.
std::string demand_text(const Collisions& demand);

}  // namespace dumbbell_verify
