#pragma once

#include "adiabatic/certificate.hpp"
#include "campaign/kind.hpp"
#include "collisions/certify.hpp"
#include "staircase/critical_range.hpp"

/// What a campaign can prove: each kind, and how its claims are cut into orders.
namespace dumbbell::campaign {

/// Constants of the adiabatic invariant for a grid of hypotheses: what `dumbbell adiabatic` proves. A unit is
/// one statement, a shard of its own, and a result the certificate that `adiabatic --out` writes. One file
/// proves one statement, so they merge to a table of the statements, which names the file of each.
[[nodiscard]] const Kind& adiabatic_kind();

/// A shard for each statement of a grid, which are all of one claim. Throws InputError if there is only one,
/// or one twice. Preconditions: require_sensible for each; 0 < accuracy <= 1.
[[nodiscard]] Plan plan_adiabatic(const std::vector<adiabatic::AdiabaticHypotheses>& grid,
                                  const Rational& accuracy);

/// The greatest number of collisions for a range of mass ratios: what `dumbbell certify LO:HI` proves. A unit
/// is a piece, a result a certificate of a run of pieces, and merged they are the file that `certify --out`
/// writes.
[[nodiscard]] const Kind& collisions_kind();

/// About 10 s of proving, and of verifying.
inline constexpr std::size_t collisions_per_shard = 1'500'000;

/// Cuts the request's range; `shards`: how many at most, if the user has a wish. Throws InputError if it is a
/// single ratio, or beyond reach. Nothing if interrupted. Calls the request's `placed`.
[[nodiscard]] std::optional<Plan> plan_collisions(const collisions::CertifyRequest& request,
                                                  std::optional<std::size_t> shards,
                                                  const Interrupted& interrupted);

/// Critical ratios: what `dumbbell critical N1:N2` encloses. A unit is one of them, a result an enclosure for
/// each, and merged they are the table that `critical --out` writes. There is no certificate of them: a
/// result is checked by the signs of the margin at both ends of each enclosure (certainly_encloses).
[[nodiscard]] const Kind& critical_kind();

/// Cuts the request's counts; `shards`: how many at most, if the user has a wish. Throws InputError if there
/// is only one.
[[nodiscard]] Plan plan_critical(const staircase::CriticalRequest& request,
                                 std::optional<std::size_t> shards);

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
/// The observer is told of the pieces that are read. Throws InputError if the file is none, or is damaged,
/// and EndedEarly if interrupted.
[[nodiscard]] VerifiedPlan plan_verified(const std::string& file, std::optional<std::size_t> shards,
                                         const Interrupted& interrupted = never, Observer& observer = nobody);

}  // namespace dumbbell::campaign
