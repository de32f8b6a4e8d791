#pragma once

#include <optional>

#include "arith/big_interval.hpp"
#include "certificate/certificate.hpp"

/// What a verified staircase says of N* as a whole.
namespace dumbbell {

/// Bounds of a supremum or an infimum, with the ratio where the inner bound is attained.
struct Extremum {
    BigInterval inner;  ///< of a value that occurs
    BigInterval outer;  ///< of the furthest value that the gaps leave possible
    Rational at;
};

struct Law {
    Rational q_lo, q_hi;
    long values = 0;  ///< pieces with one value
    long gaps = 0;
    long least = 0;                ///< N* at the lower end
    long greatest = 0;             ///< and at the upper
    bool complete = false;         ///< no piece is open; otherwise nothing below is meant
    bool never_decreases = false;  ///< N*(q) <= N*(q') for all q < q' that do not lie in the same gap
    bool below_paper = false;      ///< N*(q) <= ceil(pi / gamma) for every q
    BigInterval constant;          ///< C of theorem 4
    std::optional<Extremum> sup;   ///< of N*(q) - C sqrt q
    std::optional<Extremum> inf;
};

/// Precondition: the certificate was verified, scene dumbbell, q_hi <= paper_bound_limit(). In the thread's
/// working precision. On a piece with one value N - C sqrt q falls, so its ends decide; a gap may have either
/// of its two values anywhere.
[[nodiscard]] Law law_of(const Certificate& certificate);

}  // namespace dumbbell
