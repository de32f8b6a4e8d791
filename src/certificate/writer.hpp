#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "certificate/certificate.hpp"

namespace dumbbell {

/// A certificate as text (proofs/format.md) with the SHA-256 that its last line holds.
struct CertificateText {
    std::string text;
    std::string sha256;
};

/// The one canonical spelling. Throws BrokenInvariant if the pieces do not follow one another, or a dyadic is
/// none.
[[nodiscard]] CertificateText render(const Certificate& certificate);

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// All lines of a text but its last one, which must be `sha256 HEX` of them; nothing if it is not.
[[nodiscard]] std::optional<std::string_view> sealed_lines(std::string_view text);

/// `MbK` for M * 2^K, M odd or 0 (proofs/format.md, section 1). Precondition: the denominator is a power of
/// two, at most 2^4096.
[[nodiscard]] std::string to_dyadic(const Rational& x);

}  // namespace dumbbell
