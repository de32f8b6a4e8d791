// Is an accepted file about the adiabatic invariant a true proof of what it says? Asked of code that shares
// nothing with the verifier: the prover's reader and its formulas. (The second verifier in Python, which
// judges accepted mutants of all other claims, does not know these: ../second_opinion/mutants_test.py.)
#pragma once
#include <string>

#include "verify/wings/adiabatic/claim.hpp"

namespace dumbbell_mutation {

struct Argument {
    bool holds = false;
    std::string text;  ///< how it was shown; or what could not be shown
};

/// Of the file at `path`, which the verifier accepted with `proved` as its claim. Without `proved` of all
/// that the file says.
[[nodiscard]] Argument adiabatic_argument(const std::string& path,
                                          const dumbbell_verify::adiabatic::Claim* proved);

}  // namespace dumbbell_mutation
