#pragma once

#include "campaign/kind.hpp"

namespace dumbbell::campaign {

/// The verification of a large certificate: a unit is one of its pieces, a result the line that the
/// verifier's --shards prints of a run of them, and merged they are what its --combine takes. The orders'
/// inputs are the certificate and the verifier. A line is trusted as far as the worker is that ran the
/// verifier: only its form and what it is about are looked at here, and all that the certificate itself says
/// when they are merged.
[[nodiscard]] const Kind& verified_kind();

/// A plan with the files that become its inputs.
struct VerifiedPlan {
    Plan plan;
    std::vector<std::string> sources;
};

/// Cuts the pieces of a certificate about collisions; `shards`: how many at most, if the user has a wish.
/// Throws InputError if the file is none, or is damaged.
[[nodiscard]] VerifiedPlan plan_verified(const std::string& file, std::optional<std::size_t> shards);

}  // namespace dumbbell::campaign
