#pragma once

#include <string>
#include <vector>

#include "collisions/certificate.hpp"

namespace dumbbell::pictures {

/// From here on the law holds: a little more than q_c(9) = 62.7137030...
inline constexpr double law_from = 62.7138;

/// N(q) - C sqrt q against q (logarithmic) as a self-contained SVG: on the pieces what they prove, for every
/// greater q up to q_end the band of Theorem B of proofs/law.md, and the strips in which it leaves two
/// values. Below, q^(1/4) times as high, where the steps lie: as the pieces enclose them, and as Theorems A
/// and B say. A line is drawn only where one value is proved; open pieces are hatched. Precondition: the
/// pieces are the dumbbell's, q_lo < q_hi, law_from <= q_hi < q_end <= 1e36.
[[nodiscard]] std::string law_svg(const std::vector<collisions::Piece>& pieces, double q_end);

}  // namespace dumbbell::pictures
