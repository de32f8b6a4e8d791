#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/claim.hpp"
#include "number/rational.hpp"

namespace dumbbell::collisions {

/// A piece to be proved: the bounds that are expected to hold.
struct PlannedPiece {
    Rational q_lo;
    Rational q_hi;
    long upper;
    long lower;

    friend bool operator==(const PlannedPiece&, const PlannedPiece&) = default;
};

/// The plan of a piece that is decided.
[[nodiscard]] PlannedPiece planned_as(const Piece& piece);

/// `piece LO HI UPPER LOWER`: what names its proof among finished ones.
[[nodiscard]] std::string words_of(const PlannedPiece& planned);

struct Plan {
    std::vector<PlannedPiece> pieces;  ///< of a staircase each begins where the one before ends
    std::size_t steps_beyond = 0;      ///< about how many steps follow; 0: the last one ends at q_hi
};

/// At most so many steps are placed at a time, so that pieces can be proved while others are still unknown.
inline constexpr std::size_t most_steps_at_once = 256;

/// Cuts [q_lo, q_hi], 1 <= q_lo < q_hi, the rest of the claim's range, at the places where the maximum seems
/// to step: pieces with one value each, and between them gap pieces around the critical ratios, at most gap *
/// q wide and at most a thousandth of the distance to the next step. At q = 1 the step is known exactly: the
/// single ratio is a piece, and a gap lies to its right. The pieces begin at q_lo and end at q_hi, or behind
/// a gap when most_steps_at_once are placed: planned again from behind any gap, they go on as they would
/// have. None if it is interrupted. The observer is told how many steps are placed. Throws InputError if
/// there are more than 10^6 steps. Precondition: the steps of the section are known.
[[nodiscard]] Plan plan_staircase(const Claim& claim, const Rational& q_lo,
                                  const Interrupted& interrupted = never, Observer& observer = nobody);

}  // namespace dumbbell::collisions
