#pragma once

#include <string>

#include "certificate/certificate.hpp"

namespace dumbbell {

/// Reads a certificate file (plain or gzip) back into data, for pictures and reports. This is no
/// verification: it checks the syntax as far as it needs it, and none of the mathematics. Throws InputError
/// (naming file and line) if the file is missing or is no certificate.
[[nodiscard]] Certificate read_certificate(const std::string& path);

}  // namespace dumbbell
