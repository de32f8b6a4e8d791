#pragma once

#include "collisions/certificate.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::collisions {

/// The one canonical spelling (format.md). Throws BrokenInvariant if the pieces do not follow
/// one another, or a dyadic is none.
[[nodiscard]] SealedText render(const Certificate& certificate);

}  // namespace dumbbell::collisions
