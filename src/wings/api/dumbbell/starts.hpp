#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dumbbell/mass_ratio.hpp"
#include "dumbbell/stopped.hpp"
#include "dumbbell/trace.hpp"

/// How many starts of a box have how many collisions, with certificates (claims `initial-conditions` and
/// `incoming` of dumbbell/verify.hpp).
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

struct StartsOptions {
    std::size_t boxes = 50'000;  ///< at most so many parts; the largest are halved first
    int digits = 0;              ///< for parts that double precision does not decide; 0: none
    int jobs = 1;                ///< threads, 1 to 1024; the result does not depend on it
    std::optional<std::chrono::duration<double>> budget = std::nullopt;
    Stopped stopped = {};
};

/// For every k from `least` to `most` (empty: no end) the share of the box with exactly k collisions is at
/// least `lo` and at most `hi`, up to the starts that meet a corner.
struct StartsShare {
    long least = 0;
    std::optional<long> most;
    std::string lo;  ///< fractions
    std::string hi;
};

struct StartsProof {
    long least = 0;            ///< every start has at least so many collisions,
    std::optional<long> most;  ///< and at most so many (empty: nothing is known)
    std::vector<StartsShare> shares;
    std::string undecided;               ///< the share of the box whose number is not decided, a fraction
    std::string mean_lo;                 ///< bounds of the mean number of collisions, fractions
    std::optional<std::string> mean_hi;  ///< empty: none is proved
    std::string certificate;
    std::string sha256;
    std::string demand;  ///< of the numbers of collisions all that it says, as Claim::demand
};

/// Halves a box of starts until every part has its exact number of collisions, or there are enough parts.
/// Throws InputError as trace() does, and for options out of range.
[[nodiscard]] [[gnu::visibility("default")]] StartsProof certify_starts(const MassRatio& ratio,
                                                                        const InitialCondition& box,
                                                                        const StartsOptions& options = {});

/// The same of all trajectories that come in from above, by their natural measure (lemma L61), in double
/// precision. Throws InputError for a range of ratios.
[[nodiscard]] [[gnu::visibility("default")]] StartsProof certify_incoming(const MassRatio& ratio,
                                                                          const StartsOptions& options = {});

/// Contains the mean number of collisions of all incoming trajectories, (E(-q) + E(-1/q))/pi by Theorem 6 of
/// proofs/theorem.md. Throws InputError for a range of ratios.
[[nodiscard]] [[gnu::visibility("default")]] Interval mean_collisions(const MassRatio& ratio);

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
