#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "number/rational.hpp"

namespace dumbbell::collisions {

/// The height that the flight which decides between n - 1 and n >= 3 collisions at q (Theorem 2 (c)) has to
/// spare, in double precision: > 0 if there are n; -1 if its orbit does not come so far. Increases with q. A
/// guess, meaningless if it is interrupted.
[[nodiscard]] double guess_margin(long n, double q, const Interrupted& interrupted = never);

/// Where the maximum seems to step up to `n` (n >= 3): the critical ratio q_c(n) of theory, in double
/// precision, from the two extremal orbits. A guess that says where to split a range; every claim about the
/// pieces is proved by covers and witnesses. A meaningless number if it is interrupted.
[[nodiscard]] double guess_step(long n, const Interrupted& interrupted = never);

/// With so many bits macro steps lose about 2^-share_bits of a collision's progress.
[[nodiscard]] constexpr int bits_of_step(int share_bits) { return 4 * (share_bits + 24); }

/// A step, and two ratios 2^(5 - share_bits) of the distance to the next step below and above it.
struct FineStep {
    Rational at, below, above;
};

/// The step up to n, to about 2^-share_bits of that distance. Nothing if interrupted, or if it is not found.
/// Precondition: n >= 4, 1 <= share_bits <= 1060.
[[nodiscard]] std::optional<FineStep> find_step(long n, int share_bits,
                                                const Interrupted& interrupted = never);

}  // namespace dumbbell::collisions
