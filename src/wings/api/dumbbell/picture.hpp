#pragma once

#include <string>

#include "dumbbell/certify.hpp"
#include "dumbbell/starts.hpp"

/// Pictures of what was proved, as self-contained SVG.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// Of a range the staircase of N(q), with 2 + C sqrt q and the source paper's bound; of a single ratio an
/// orbit with the most collisions. Throws InputError where there is none: a ratio beyond 3e31, more than
/// 20,000 collisions, a piece without an orbit.
[[nodiscard]] [[gnu::visibility("default")]] std::string picture(const Proof& proof);

/// The starts by their number of collisions. Throws InputError unless exactly two of their quantities are
/// intervals, and for more than 200,000 parts.
[[nodiscard]] [[gnu::visibility("default")]] std::string picture(const StartsProof& proof);

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
