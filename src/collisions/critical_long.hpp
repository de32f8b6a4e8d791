#pragma once

#include "collisions/critical.hpp"

/// Critical ratios of long orbits: they are followed by macro steps (L42), which give bounds of a state, but
/// not of its derivatives. By Theorem 2 the numbers of collisions at two ratios enclose them all the same.
namespace dumbbell::collisions {

/// From here on it is faster than the interval Newton step of critical.cpp, which takes 0.36 s for n = 20,000
/// to 15 digits: this takes 0.18 s for the next one, and 0.34 s for n = 10^12.
inline constexpr long first_long = 20'001;
[[nodiscard]] constexpr bool is_long(long n) { return n >= first_long; }

/// Where N* seems to step up to n, to about 2^-share_bits of the distance to the next step: a guess. Nothing
/// if interrupted, or if it is not found. Precondition: is_long(n), 1 <= share_bits <= 2000.
[[nodiscard]] std::optional<Rational> guess_long_critical_ratio(long n, int share_bits,
                                                                const Interrupted& interrupted = never);

/// As enclose_critical_ratio, for n with is_long(n).
[[nodiscard]] std::optional<CriticalRatio> enclose_long_critical_ratio(long n,
                                                                       const CriticalOptions& options);

/// Whether it is certain that q_lo <= q_c(n) <= q_hi (Theorem 2), by the counts at both ends with so many
/// bits.
[[nodiscard]] bool certainly_encloses_by_counts(const CriticalRatio& ratio,
                                                const Interrupted& interrupted = never);

}  // namespace dumbbell::collisions
