#pragma once

#include "campaign/kind.hpp"
#include "collisions/certify.hpp"

namespace dumbbell::campaign {

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

}  // namespace dumbbell::campaign
