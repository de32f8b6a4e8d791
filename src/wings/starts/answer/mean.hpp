#pragma once

#include <optional>
#include <string>

#include "number/big_interval.hpp"
#include "starts/answer/shares.hpp"
#include "starts/cover/certificate.hpp"

/// How often incoming trajectories hit the floor on average: what the leaves of a tree prove of it, and
/// Theorem 6, or L85 of bodies, which says it exactly.
namespace dumbbell::starts {

/// Of all incoming trajectories, by their natural measure: Theorem 6 of proofs/theorem.md, L85 of body.md.
struct ExactMean {
    BigInterval all;    ///< the mean number of collisions, (E(-Q) + E(-Q rho^2))/pi
    BigInterval heavy;  ///< that of the heavy end's, E(-Q rho^2)/pi; of a dumbbell its probability
};
/// Of the body (rho, Q), or without rho of the dumbbell of mass ratio Q, whose rho is 1/Q. With the thread's
/// working precision. Preconditions: Q > 0, 0 < rho <= 1.
[[nodiscard]] ExactMean exact_mean(const Rational& q, const std::optional<Rational>& rho = std::nullopt);

/// What both say. Throws BrokenInvariant if the exact mean lies outside the bounds of a complete tree about
/// `all`, the incoming trajectories of a body or dumbbell.
[[nodiscard]] std::string mean_text(const Box& all, const PackedTree& tree);
[[nodiscard]] Json mean_json(const Box& all, const PackedTree& tree);

}  // namespace dumbbell::starts
