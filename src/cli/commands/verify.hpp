#pragma once

#include <string>
#include <string_view>

#include "cli/terminal/progress.hpp"

/// The program `dumbbell-verify` that lies beside this one. It shares no code with this program, so it is
/// run, never called.
namespace dumbbell {

/// Becomes the verifier, with the arguments behind `verify`; its exit code is the verifier's. Returns only if
/// it cannot be started: throws InputError.
[[noreturn]] void become_verifier(int argc, char** argv);

/// The verifier's verdict on a certificate of this scene, its last line. Throws InputError, with that
/// line, if the file is not verified.
[[nodiscard]] std::string verified(const std::string& file, std::string_view scene,
                                   Loudness loudness = Loudness::normal);

}  // namespace dumbbell
