#pragma once

#include "number/rational.hpp"

namespace dumbbell::flight {

/// ceil(pi / corner), exactly, for the corner between the two humps of the body (rho, Q) (lemma L73): so many
/// collisions are possible close to it, and if rho = 1 no motion has more (L72). `most` + 1 if it is greater
/// than `most`. Preconditions: rho > 0, Q > 0, most >= 1.
[[nodiscard]] long corner_count(const Rational& rho, const Rational& q, long most);

}  // namespace dumbbell::flight
