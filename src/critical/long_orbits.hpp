#pragma once

#include "critical/enclose.hpp"

/// The critical ratios of long orbits: they are followed by macro steps (L42), which give bounds of a state,
/// but not of its derivatives. By Theorem 2 the numbers of collisions at two ratios enclose them all the
/// same.
namespace dumbbell::critical {

/// As enclose_ratio, for n with collisions::is_long(n).
[[nodiscard]] std::optional<Ratio> enclose_long_ratio(long n, const Options& options);

/// Whether it is certain that q_lo <= q_c(n) <= q_hi (Theorem 2), by the counts at both ends with so many
/// bits.
[[nodiscard]] bool certainly_encloses_by_counts(const Ratio& ratio, const Interrupted& interrupted = never);

}  // namespace dumbbell::critical
