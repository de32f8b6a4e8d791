#pragma once

#include <variant>

#include "adiabatic/certificate.hpp"
#include "collisions/certificate.hpp"
#include "starts/cover/certificate.hpp"

namespace dumbbell::page {

using AnyCertificate = std::variant<collisions::Certificate, starts::Certificate, adiabatic::Certificate>;

/// Reads a certificate of any claim kind but those of the law. No verification; throws InputError (naming
/// file and line) if the file is missing or is none of them.
[[nodiscard]] AnyCertificate read_any_certificate(const NamedFile& file);

}  // namespace dumbbell::page
