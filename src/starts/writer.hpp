#pragma once

#include "file/sealed_lines.hpp"
#include "starts/certificate.hpp"

namespace dumbbell::starts {

/// The one canonical spelling (format-initial.md). Throws BrokenInvariant if the tree is not complete.
[[nodiscard]] SealedText render(const Certificate& certificate);

}  // namespace dumbbell::starts
