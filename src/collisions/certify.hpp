#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "base/observer.hpp"
#include "collisions/piece.hpp"
#include "collisions/piece_store.hpp"

namespace dumbbell::collisions {

struct CertifyRequest {
    Claim claim;  ///< of ratios from 1 on
    int jobs = 1;
    std::optional<std::chrono::duration<double>> budget = {};
    bool describes = true;              ///< as in PieceOptions
    const PieceStore* store = nullptr;  ///< ranges: where finished pieces are kept, and found again
    /// Told of the boxes that are judged for a single ratio; for a range of the critical ratios that are
    /// placed, then in a phase of its own of the pieces that are finished, with the maximum that was looked
    /// for.
    Observer* observer = &nobody;
};

/// Proves the request piece by piece. Pieces that cannot be decided, or not within the budget, are left open.
/// The result does not depend on the number of jobs. Throws BrokenInvariant if the arithmetic of a thread is
/// not sound.
[[nodiscard]] std::vector<ProvedPiece> certify(const CertifyRequest& request);

/// The share of [q_lo, q_hi] whose pieces are gaps or open, exactly; 0 for a single decided ratio, else 1.
[[nodiscard]] Rational undecided_share(const std::vector<ProvedPiece>& pieces);

}  // namespace dumbbell::collisions
