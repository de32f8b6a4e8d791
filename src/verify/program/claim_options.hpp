// The options that state a claim, the same on the command line and in a list of claims.
#pragma once
#include "verify/program/arguments.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// Puts the present option into the settings if it is one of --ratio, --rho, --max, --min, --exactly,
/// --scene, --claim and those of number_option(); false if it is another. Throws std::invalid_argument.
bool claim_option(Arguments& given, Request& settings);

/// Throws std::invalid_argument if these options lack one that another of them needs, or do not fit.
void require_whole(const Request& settings);

/// What a file must prove by itself.
const Collisions& own_demand(const Settings& settings);

/// What was demanded, of it and with the scene and the kind of `settings`: ` demanded-ratio=LO:HI
/// demanded-rho=LO:HI max=N min=N demanded-scene=S demanded-claim=KIND demanded-phi=LO:HI ...` without what
/// was not; ` exactly=N` for both bounds.
std::string demand_text(const Request& settings, const Collisions& demand);

}  // namespace dumbbell_verify
