#pragma once

#include "adiabatic/search.hpp"

/// Statements of the paper that fail as they are printed: where, and by how much.
namespace dumbbell::adiabatic {

/// Scatterings that begin as far from the vertical as Theorem 3.5 asks, with |ydot| >= delta/2, and change I
/// by order 1: their last collision is so near the vertical that it takes almost all of |phidot| (L41). In
/// plain doubles; those with the greatest change first.
[[nodiscard]] std::vector<AdiabaticSample> search_printed(const AdiabaticSearch& search);

/// By how much (5) of Lemma 3.1 as printed is wrong for phidot_- > 0 at this state (L38 (c)): a lower bound,
/// over epsilon/delta = delta.
[[nodiscard]] double printed_branch_error(const AdiabaticState& state);

}  // namespace dumbbell::adiabatic
