#pragma once

#include "collisions/writer.hpp"
#include "starts/certificate.hpp"

namespace dumbbell {

/// The one canonical spelling (format-initial.md). Throws BrokenInvariant if the tree is not complete.
[[nodiscard]] CertificateText render(const InitialCertificate& certificate);

}  // namespace dumbbell
