#pragma once

#include <optional>
#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell::collisions {

/// What a certificate is about, as its head says; nothing if it has none that can be read.
struct ClaimedRange {
    Scene scene;
    Section section;
    Rational q_lo, q_hi;
};
[[nodiscard]] std::optional<ClaimedRange> claimed_range(const std::string& file);

/// A certificate that `dumbbell-verify` accepts, on so many threads. Throws InputError, saying what it
/// answers, if it does not, or if the file was exchanged since; NoVerdict if it does not answer.
[[nodiscard]] Certificate verified_certificate(const std::string& file, int jobs);

}  // namespace dumbbell::collisions
