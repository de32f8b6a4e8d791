#pragma once

#include <optional>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "law/certificate.hpp"
#include "law/constants.hpp"

namespace dumbbell::law {

/// Exact fractions A < B with q_c(n) in [A, B] as it seems, so near that they show what the law says of the
/// step, and far enough that little has to be proved: a guess, which cover and witness must confirm.
/// Precondition: first_step <= n <= last_step.
[[nodiscard]] StepEnds step_ends(long n, const Constants& constants);

/// Whether certainly, for all q_c in [A, B]: -0.115 <= delta <= 0.02, and for n >= 9 0 < delta < c0
/// q_c^(-1/4), delta = C sqrt q_c - (n - 2).
[[nodiscard]] bool shows_the_law(long n, const StepEnds& ends, const Constants& constants);

/// All steps with their proofs; nothing if interrupted, or if one of them cannot be proved. On all of the
/// calling arena's threads; the result does not depend on their number. The observer is told of steps that
/// are proved.
[[nodiscard]] std::optional<std::vector<collisions::Piece>> prove_steps(const Interrupted& interrupted,
                                                                        Observer& observer = nobody);

}  // namespace dumbbell::law
