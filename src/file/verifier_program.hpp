#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

/// The program `dumbbell-verify` that lies next to this one. It shares no code with this program, so it is
/// run, never called.
namespace dumbbell {

[[nodiscard]] std::string verifier_path();

/// The verifier could not be started, or did not come to its end: that says nothing about the file.
class NoVerdict : public InputError {
    using InputError::InputError;
};

/// What it says of one file.
struct Verdict {
    bool accepts = false;  ///< the file is right; all that it is about may be open
    std::string line;      ///< the last one that it printed
};

/// Runs the verifier, or another copy of it, with these arguments; its stderr is this program's. A signal
/// that asks this program to stop ends it early. May be used by several threads at once. Throws NoVerdict.
[[nodiscard]] Verdict ask_verifier(std::vector<std::string> arguments, std::string program = verifier_path());

/// The SHA-256 that an accepting line names.
[[nodiscard]] std::string digest_in(const std::string& verdict);

/// For a caller that could not start it: throws NoVerdict.
[[noreturn]] void verifier_not_started(const std::string& program, int error);

}  // namespace dumbbell
