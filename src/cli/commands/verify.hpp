#pragma once

#include <string>

#include "base/observer.hpp"
#include "collisions/certificate.hpp"

/// The program `dumbbell-verify` that lies next to this one. It shares no code with this program, so it is
/// run, never called.
namespace dumbbell::cli {

/// The verifier's verdict on a certificate about this system, its last line. `sha256` is that of what was
/// read from the file (Lines::digest), which may have been exchanged since. Throws InputError, with that
/// line, if the file is not verified, and if it is another one. It is a phase of its own of the work that is
/// observed; SIGINT and SIGTERM end the verifier and the program.
[[nodiscard]] std::string verified(const std::string& file, const std::string& sha256,
                                   const collisions::System& system, Observer& observer);

/// The same for a certificate of the law for every mass ratio, of which nothing else is read.
[[nodiscard]] std::string verified_law(const std::string& file, Observer& observer);

}  // namespace dumbbell::cli
