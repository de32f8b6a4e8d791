// Which options fit which kind of claim, and the numbers of claims about starts and the adiabatic invariant.
#pragma once
#include <map>

#include "verify/program/arguments.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// The options that state a claim, as they were given; what a number means depends on all of them.
using ClaimWords = std::map<std::string, std::string>;

/// Is it an option that demands something of a file: --ratio, --phi, --delta and so on?
bool is_claim_option(std::string_view option);

/// The values of --phi, --phidot, --y, --ydot, --decided, --delta, --heights, --margin, --exponent,
/// --constant and --attained. Throws std::invalid_argument.
Numbers numbers_of(const ClaimWords& words);

/// Throws std::invalid_argument if an option does not fit the kind of claim that is demanded.
void require_fitting_kind(const Request& request);

/// ` demanded-phi=LO:HI`, and so on.
std::string numbers_text(const Numbers& numbers);

/// What could have been demanded of such a file and was not, with `between` between the names; empty where
/// nothing at all was demanded.
std::string not_demanded(const Verified& proof, const Request& request, std::string_view between);

}  // namespace dumbbell_verify
