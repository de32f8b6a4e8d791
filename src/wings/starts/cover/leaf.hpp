#pragma once

#include "starts/cover/certificate.hpp"

namespace dumbbell::starts {

/// What the rules of format-initial.md certify of a box in double precision, and if that does not decide it
/// with `bits` bits (53: double only); made for a box a little larger, so that another implementation has
/// slack. Precondition: require_in_play(box).
[[nodiscard]] Leaf judge(const Box& box, int bits);

/// What they certify of all falling states at the mass ratios of the box.
[[nodiscard]] Leaf judge_falling(const Box& box);

/// No trajectory at a mass ratio of the box has more collisions (Theorem 1), also beyond the counts that a
/// certificate's leaf may bound; of a body L72 or L84. Nothing beyond 2^53.
[[nodiscard]] std::optional<long> most_of_all(const Box& box);

}  // namespace dumbbell::starts
