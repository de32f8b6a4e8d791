#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/certificate.hpp"
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

/// Cuts [q_lo, q_hi], 1 <= q_lo < q_hi, at the places where the maximum seems to step: pieces with one value
/// each, and between them gap pieces around the critical ratios, at most gap * q wide and at most a
/// thousandth of the distance to the next step. At q = 1 the step is known exactly: the single ratio is a
/// piece, and a gap lies to its right. Empty if it is interrupted. `placed` is called, from any thread, with
/// the numbers of steps that are placed and of all. Throws InputError if there are more than 10^6 steps.
[[nodiscard]] std::vector<PlannedPiece> plan_staircase(Scene scene, const Rational& q_lo,
                                                       const Rational& q_hi, const Rational& gap,
                                                       const Interrupted& interrupted = never,
                                                       Observer& observer = nobody);

}  // namespace dumbbell::collisions
