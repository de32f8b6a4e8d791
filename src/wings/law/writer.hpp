#pragma once

#include "file/sealed_lines.hpp"
#include "law/certificate.hpp"

namespace dumbbell::law {

/// The one canonical spelling (docs/reference/format-law.md).
[[nodiscard]] SealedText render(const LawCertificate& certificate);

}  // namespace dumbbell::law
