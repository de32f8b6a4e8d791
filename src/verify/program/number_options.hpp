// The options with numbers of claims about starts and about the adiabatic invariant, and which options fit
// which kind of claim.
#pragma once
#include "verify/program/arguments.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// Puts the present option into `numbers` if it is one of --phi, --phidot, --y, --ydot, --decided, --delta,
/// --heights, --margin, --exponent, --constant and --attained; false if it is another. Throws
/// std::invalid_argument.
bool number_option(Arguments& given, starts::Numbers& numbers);

/// Throws std::invalid_argument if an option does not fit the kind of claim that is demanded.
void require_fitting_kind(const Request& request);

/// ` demanded-phi=LO:HI`, and so on.
std::string numbers_text(const starts::Numbers& numbers);

/// What could have been demanded of such a file and was not, with `between` between the names; empty where
/// nothing at all was demanded, and for files about numbers of collisions.
std::string not_demanded(const Verified& proof, const Request& request, std::string_view between);

}  // namespace dumbbell_verify
