#pragma once

#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell {

/// A certificate as text (format.md) with the SHA-256 that its last line holds.
struct CertificateText {
    std::string text;
    std::string sha256;
};

/// The one canonical spelling. Throws BrokenInvariant if the pieces do not follow one another, or a dyadic is
/// none.
[[nodiscard]] CertificateText render(const Certificate& certificate);

}  // namespace dumbbell
