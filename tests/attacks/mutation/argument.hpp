// The second argument: is an accepted file a true proof of what it says? Asked of code that shares nothing
// with the verifier: the prover's reader, the exact audit of the tiling, and the prover's own judgement of
// every leaf.
#pragma once
#include <string>

#include "verify/program/verify.hpp"

namespace dumbbell_mutation {

struct Argument {
    bool holds = false;
    std::string text;  ///< how it was shown; or what could not be shown
};

/// Of the file at `path`, which the verifier accepted with `proof` as its claim.
[[nodiscard]] Argument second_argument(const std::string& path, const dumbbell_verify::Verified& proof);

/// The same of a file about initial conditions.
[[nodiscard]] Argument initial_argument(const std::string& path, const dumbbell_verify::Initial& proved);

/// The same of a file about the adiabatic invariant. Without `proved` of all that the file says.
[[nodiscard]] Argument adiabatic_argument(const std::string& path, const dumbbell_verify::Adiabatic* proved);

}  // namespace dumbbell_mutation
