#pragma once

#include <string>
#include <vector>

#include "collisions/certify.hpp"

/// One line of advice for users who did not get all that they asked for.
namespace dumbbell::cli {

/// Why pieces are open, and what to do. `partial`: the folder of the finished pieces, empty if none is kept.
/// Precondition: some piece is open.
[[nodiscard]] std::string advice(const collisions::CertifyRequest& request,
                                 const std::vector<collisions::ProvedPiece>& pieces,
                                 const std::string& partial);

/// What a run that was stopped by a signal keeps.
[[nodiscard]] std::string kept_when_stopped(const collisions::CertifyRequest& request,
                                            const std::vector<collisions::ProvedPiece>& pieces,
                                            const std::string& partial);

}  // namespace dumbbell::cli
