#pragma once

#include <vector>

#include "collisions/certificate.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::collisions {

/// The one canonical spelling (format.md). Throws BrokenInvariant if the pieces do not follow
/// one another, or a dyadic is none.
[[nodiscard]] SealedText render(const Certificate& certificate);
/// The same of a frame without pieces, and of pieces that are elsewhere: their trees can be large.
[[nodiscard]] SealedText render(const Certificate& frame, const std::vector<const Piece*>& pieces);

}  // namespace dumbbell::collisions
