#pragma once

#include <functional>
#include <vector>

#include "collisions/piece.hpp"

/// Ranges of which nothing is known where the maximum steps.
namespace dumbbell::collisions {

struct Halving {
    /// What seems to be the maximum at Q; nothing if that is not found in time.
    std::function<std::optional<Count>(const Rational& q)> maximum;
    std::function<ProvedPiece(const Rational& q_lo, const Rational& q_hi, long upper, long lower)> prove;
    Rational gap;  ///< parts that are narrower, relatively, are not halved
};

/// Pieces of one value where the ends of a part seem to have it and the proof succeeds; other parts are
/// halved, and the narrowest are gaps or open.
[[nodiscard]] std::vector<ProvedPiece> prove_halved(const Rational& q_lo, const Rational& q_hi,
                                                    const Halving& by);

}  // namespace dumbbell::collisions
