#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "number/rational.hpp"

namespace dumbbell {

/// A piece to be proved: the bounds that are expected to hold.
struct PlannedPiece {
    Rational q_lo;
    Rational q_hi;
    long upper;
    long lower;
};

/// Cuts [q_lo, q_hi], 1 <= q_lo < q_hi, at the places where the maximum seems to step: pieces with one value
/// each, and between them gap pieces around the critical ratios, at most gap * q wide and at most a
/// thousandth of the distance to the next step. At q = 1 the step is known exactly: the single ratio is a
/// piece, and a gap lies to its right. Empty if it is interrupted. `placed` is called, from any thread, with
/// the numbers of steps that are placed and of all. Throws InputError if there are more than 10^6 steps.
[[nodiscard]] std::vector<PlannedPiece> plan_staircase(
    Scene scene, const Rational& q_lo, const Rational& q_hi, const Rational& gap,
    const Interrupted& interrupted = never,
    const std::function<void(std::size_t, std::size_t)>& placed = [](std::size_t, std::size_t) {});

}  // namespace dumbbell
