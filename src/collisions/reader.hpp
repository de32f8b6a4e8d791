#pragma once

#include <cstddef>
#include <string>

#include "collisions/certificate.hpp"
#include "file/lines.hpp"

namespace dumbbell::collisions {

/// What a certificate about collisions says of itself before its pieces.
struct ClaimedHead {
    Generator generator;
    System system;
    Range range;
    std::size_t pieces;
};

/// Reads no further. Throws InputError as read_certificate does.
[[nodiscard]] ClaimedHead read_head(const std::string& path);

/// How many pieces a certificate has, as its head says; 0 if it is none about collisions.
[[nodiscard]] std::size_t claimed_pieces(const std::string& path);

/// Reads a certificate file (plain or gzip) back into data, for pictures and reports. This is no
/// verification: it checks the syntax as far as it needs it, and none of the mathematics. Throws InputError
/// (naming file and line) if the file is missing or is no certificate.
[[nodiscard]] Certificate read_certificate(const NamedFile& file);

}  // namespace dumbbell::collisions
