#pragma once

#include <optional>

#include "collisions/certificate.hpp"
#include "number/big_interval.hpp"

/// What a verified staircase says of N(q) as a whole.
namespace dumbbell::staircase {

/// All that is proved of N at one mass ratio: that it is one of these numbers.
struct Bounds {
    long lower = 0;
    long upper = 0;
};

/// Bounds of a supremum or an infimum, with the ratio where the inner bound is attained.
struct Extremum {
    BigInterval inner;  ///< of a value that occurs
    BigInterval outer;  ///< of the furthest value that the gaps leave possible
    Rational at;
    /// Whether it is attained, or the limit from above at a step and no value; nothing if the pieces leave
    /// that open.
    std::optional<bool> attained;
};

struct Law {
    Rational q_lo, q_hi;
    long values = 0;  ///< pieces with one value
    long gaps = 0;
    Bounds first;                  ///< of N at q_lo
    Bounds last;                   ///< and at q_hi
    bool complete = false;         ///< no piece is open; otherwise nothing below is meant
    bool never_decreases = false;  ///< N(q) <= N(q') for all q < q' that do not lie in the same gap
    bool below_paper = false;      ///< N(q) <= ceil(pi / gamma) for every q
    BigInterval constant;          ///< C of theorem 4
    std::optional<Extremum> sup;   ///< of N(q) - C sqrt q
    std::optional<Extremum> inf;
};

/// Precondition: the certificate was verified, scene dumbbell, q_hi <= paper_bound_limit(). In the thread's
/// working precision. On a piece with one value N - C sqrt q falls, so its ends decide; a gap may have either
/// of its two values anywhere. Whether the supremum is attained rests on theorem 2 of proofs/theorem.md.
[[nodiscard]] Law law_of(const collisions::Certificate& certificate);

}  // namespace dumbbell::staircase
