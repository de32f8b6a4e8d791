#pragma once

#include <optional>
#include <span>
#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell::collisions {

/// What the check of these pieces costs the verifier at most, in seconds of a core by its own count of work
/// (format.md, section 4): 4096 units for a collision in double, less than 40 (b + 64)^2 with b bits; of a
/// ray with 20,000 collisions or more, what macro steps cost (L42), which grows with the fourth power of log
/// q; 6 * 10^9 units a second. Nothing that is proved rests on it.
[[nodiscard]] double check_seconds(std::span<const Piece* const> pieces, Section section);

/// `--budget TIME ` if the verifier must be given more than it takes without being asked, else empty. Nothing
/// if it takes no budget that is certainly enough.
[[nodiscard]] std::optional<std::string> budget_option(double seconds);

}  // namespace dumbbell::collisions
