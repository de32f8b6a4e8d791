#pragma once

#include <string>
#include <variant>

#include "adiabatic/certificate.hpp"
#include "collisions/certificate.hpp"
#include "starts/certificate.hpp"

namespace dumbbell::certificates {

using AnyCertificate =
    std::variant<collisions::Certificate, starts::InitialCertificate, adiabatic::AdiabaticCertificate>;

/// Reads a certificate of any claim kind but those of the law. No verification; throws InputError (naming
/// file and line) if the file is missing or is none of them.
[[nodiscard]] AnyCertificate read_any_certificate(const std::string& path);

/// The SHA-256 in the last line of a certificate, if it is the one of the text before it. Throws InputError
/// if it is not, or if there is none: the file is damaged, incomplete or no certificate. (It proves nothing:
/// whoever forges a file can compute one.)
[[nodiscard]] std::string sealed_digest(const std::string& path);

}  // namespace dumbbell::certificates
