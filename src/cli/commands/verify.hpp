#pragma once

#include <string>
#include <string_view>

#include "base/observer.hpp"

/// The program `dumbbell-verify` that lies next to this one. It shares no code with this program, so it is
/// run, never called.
namespace dumbbell::cli {

/// The verifier's verdict on a certificate of this scene, its last line. Throws InputError, with that
/// line, if the file is not verified. It is a phase of its own of the work that is observed.
[[nodiscard]] std::string verified(const std::string& file, std::string_view scene, Observer& observer);

/// The same for a certificate of the law for every mass ratio.
[[nodiscard]] std::string verified_law(const std::string& file, Observer& observer);

}  // namespace dumbbell::cli
