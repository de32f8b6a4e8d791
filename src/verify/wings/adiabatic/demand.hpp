// What is demanded of files about the adiabatic invariant.
#pragma once
#include "verify/wings/adiabatic/claim.hpp"

namespace dumbbell_verify::adiabatic {

/// What is demanded of the claim and not proved by it; empty: nothing. A demand of attained values is about
/// states within the delta, heights and margin that are demanded: of the latter two only the file's will do.
std::string missing(const Claim& claim, const Numbers& numbers);

}  // namespace dumbbell_verify::adiabatic
