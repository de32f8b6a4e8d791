#pragma once

#include <optional>
#include <string>

#include "collisions/claim.hpp"

namespace dumbbell::collisions {

/// What a certificate says it is about; nothing if it has no head that can be read.
[[nodiscard]] std::optional<Claim> claim_in(const std::string& file);

/// A certificate that `dumbbell-verify` accepts, on so many threads. Throws InputError, saying what it
/// answers, if it does not, or if the file was exchanged since; NoVerdict if it does not answer.
[[nodiscard]] Certificate verified_certificate(const std::string& file, int jobs);

}  // namespace dumbbell::collisions
