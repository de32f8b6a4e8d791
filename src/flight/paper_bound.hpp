#pragma once

#include "number/rational.hpp"

namespace dumbbell::flight {

/// The greatest ratio that paper_bound takes: 3e31; beyond, m is no longer an exact double.
[[nodiscard]] Rational paper_bound_limit();

/// The source paper's bound ceil(pi / gamma) + 1, gamma = pi - 2 atan(sqrt q), exactly, for q >= 1.
///
/// pi / gamma <= m iff tan(pi / 2m) <= tan(gamma / 2) = 1 / sqrt q iff q <= cot^2(pi / 2m) = (1 + cos(pi/m))
/// / (1 - cos(pi/m)). With q rational, equality needs a rational cos(pi/m): by Niven's theorem m = 2 (q = 1)
/// or m = 3 (q = 3). So enclosures decide all other cases at some precision. Precondition: 1 <= q <=
/// paper_bound_limit().
[[nodiscard]] long paper_bound(const Rational& q);

}  // namespace dumbbell::flight
