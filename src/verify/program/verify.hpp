// One certificate file of any claim kind.
#pragma once
#include <optional>
#include <string>

#include "verify/adiabatic/claim.hpp"
#include "verify/format/proof.hpp"
#include "verify/format/text.hpp"
#include "verify/law/claim.hpp"
#include "verify/starts/claim.hpp"

namespace dumbbell_verify {

/// What a file proves: `claim`, or instead one of these.
struct Verified : Proof {
    std::optional<Initial> initial;      ///< if the file is about initial conditions
    std::optional<Adiabatic> adiabatic;  ///< if it is about the adiabatic invariant
    std::optional<Law> law;              ///< if it is about the law
    std::optional<LawAtRatio> by_law;    ///< if it is about one mass ratio by the law
};

/// Returns only if all that the file and the demand say is certified, but for the leaves and witnesses of the
/// pieces that `settings` does not have checked; else throws the Failure of the least line.
Verified verify(const std::string& path, const Settings& settings);

}  // namespace dumbbell_verify
