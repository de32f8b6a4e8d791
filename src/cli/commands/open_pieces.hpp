#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collisions/certify.hpp"

/// One line of advice for users who did not get all that they asked for.
namespace dumbbell::cli {

/// The folder of the finished pieces, and how many it has, also of earlier runs: one that ends while it looks
/// for steps has none of its own.
struct KeptPieces {
    std::string folder;
    std::size_t number = 0;
};

/// Why pieces are open, and what to do. `kept`: nothing if no piece is kept. Precondition: some piece is
/// open.
[[nodiscard]] std::string advice(const collisions::CertifyRequest& request,
                                 const std::vector<collisions::ProvedPiece>& pieces,
                                 const std::optional<KeptPieces>& kept);

/// What a run that was stopped by a signal keeps.
[[nodiscard]] std::string kept_when_stopped(const collisions::CertifyRequest& request,
                                            const std::vector<collisions::ProvedPiece>& pieces,
                                            const std::optional<KeptPieces>& kept);

}  // namespace dumbbell::cli
