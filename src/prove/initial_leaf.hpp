#pragma once

#include "certificate/initial_certificate.hpp"

namespace dumbbell {

/// What the plain natural evaluation of format-initial.md certifies of a box in double precision, made for a
/// box a little larger, so that another implementation has slack. Precondition: require_in_play(box).
[[nodiscard]] InitialLeaf judge_initial(const InitialBox& box);

}  // namespace dumbbell
