#pragma once

#include "file/sealed_lines.hpp"
#include "law/at_ratio.hpp"
#include "law/certificate.hpp"

namespace dumbbell::law {

/// The one canonical spelling (docs/reference/format-law.md).
[[nodiscard]] SealedText render(const LawCertificate& certificate);
/// The certificate `collisions-by-law` of this answer, which rests on the law's certificate with this
/// SHA-256.
[[nodiscard]] SealedText render(const AtRatio& at, const std::string& law_sha256);

}  // namespace dumbbell::law
