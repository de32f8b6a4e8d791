#pragma once

#include <string>

namespace dumbbell {

/// The SHA-256 in the last line of a certificate, if it is the one of the text before it. Throws InputError
/// if it is not, or if there is none: the file is damaged, incomplete or no certificate. (It proves nothing:
/// whoever forges a file can compute one.)
[[nodiscard]] std::string sealed_digest(const std::string& path);

}  // namespace dumbbell
