#pragma once

#include <string>

#include "number/big_interval.hpp"
#include "starts/answer/shares.hpp"

/// How often incoming trajectories hit the floor on average: what the leaves of a tree prove of it, and
/// Theorem 6, which says it exactly.
namespace dumbbell::starts {

/// Theorem 6 of proofs/theorem.md: of all incoming trajectories, by their natural measure.
struct ExactMean {
    BigInterval all;    ///< the mean number of collisions, (E(-q) + E(-1/q))/pi
    BigInterval heavy;  ///< the probability that the heavy mass hits the floor, E(-1/q)/pi
};
/// With the thread's working precision. Precondition: q >= 1.
[[nodiscard]] ExactMean exact_mean(const Rational& q);

/// What both say. Throws BrokenInvariant if the exact mean lies outside the bounds of a complete tree about
/// the incoming trajectories at the mass ratio q.
[[nodiscard]] std::string mean_text(const Rational& q, const PackedTree& tree);
[[nodiscard]] Json mean_json(const Rational& q, const PackedTree& tree);

}  // namespace dumbbell::starts
