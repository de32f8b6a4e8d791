#pragma once

namespace dumbbell {

/// Becomes the program `dumbbell-verify` that lies beside this one, with the arguments behind `verify`; its
/// exit code is the verifier's. The verifier shares no code with this program, so nothing is parsed here.
/// Returns only if it cannot be started: throws InputError.
[[noreturn]] void become_verifier(int argc, char** argv);

}  // namespace dumbbell
