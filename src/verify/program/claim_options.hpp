// The options that state a claim, the same on the command line and in a list of claims.
#pragma once
#include "verify/program/arguments.hpp"
#include "verify/program/number_options.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// Takes the present option if it is one of them; false if it is another. Throws std::invalid_argument.
bool claim_option(Arguments& given, ClaimWords& words);

/// What they demand, together. Throws std::invalid_argument if one of them is no number, does not fit the
/// kind of claim, or needs another one.
void state_claim(const ClaimWords& words, Request& settings);

/// What was demanded: ` demanded-ratio=LO:HI
/// demanded-inertia=LO:HI demanded-rho=LO:HI max=N min=N demanded-gap=REL demanded-gaps=N demanded-scene=S
/// demanded-claim=KIND demanded-phi=LO:HI ...` without what was not; ` exactly=N` for both bounds.
std::string demand_text(const Request& settings);

}  // namespace dumbbell_verify
