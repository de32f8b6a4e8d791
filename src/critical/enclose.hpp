#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "number/rational.hpp"

namespace dumbbell::critical {

/// The critical ratio q_c(n), n >= 3, enclosed: q_lo <= q_c(n) <= q_hi.
///
/// The interval Newton operator maps a bracket of r = 1/q into itself: in the bracket exactly one r makes the
/// flight of tangent_flight(n) tangent to the hump. That this is the place where the maximum steps rests on
/// Theorem 2 of proofs/theorem.md, which no cover uses.
struct Ratio {
    long n = 0;
    Rational q_lo;
    Rational q_hi;   ///< equal to q_lo only for n = 3, q_c = 1
    int bits = 0;    ///< working precision
    long below = 0;  ///< of bodies: N at the one end, where it is n at the other
};

struct Row {
    long n = 0;
    std::optional<Ratio> ratio;  ///< nothing: not within the budget
};

struct Options {
    int digits = 15;  ///< significant digits that all of [q_lo, q_hi] share
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of flights that are enclosed
};

inline constexpr int most_digits = 1000;
inline constexpr int most_bits = 16384;

/// Nothing if interrupted, or if 16,384 bits do not give the digits. Precondition: n >= 3, 1 <= digits <=
/// 1000.
[[nodiscard]] std::optional<Ratio> enclose_ratio(long n, const Options& options);

/// The same for long orbits, flight::macro::is_long(n) (long_orbits.cpp): macro steps (L42) bound a state,
/// but not its derivatives; by Theorem 2 the numbers of collisions at two ratios enclose n all the same.
[[nodiscard]] std::optional<Ratio> enclose_long_ratio(long n, const Options& options);
[[nodiscard]] bool certainly_encloses_by_counts(const Ratio& ratio, const Interrupted& interrupted = never);

}  // namespace dumbbell::critical
