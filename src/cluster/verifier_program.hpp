#pragma once

#include <string>
#include <vector>

/// The program `dumbbell-verify` that lies beside this one. It shares no code with this program, so it is
/// run, never called.
namespace dumbbell {

[[nodiscard]] std::string verifier_path();

/// What a run of the verifier printed on stdout, and its exit code, or -1 if it did not come to its end.
struct VerifierAnswer {
    std::string out;
    int code = -1;
};

/// Runs it, or another copy of it, with these arguments; its stderr is this program's. May be used by several
/// threads at once. Throws InputError if it cannot be started.
[[nodiscard]] VerifierAnswer ask_verifier(std::vector<std::string> arguments,
                                          std::string program = verifier_path());

/// For whoever could not start it: throws InputError.
[[noreturn]] void verifier_not_started(const std::string& program, int error);

}  // namespace dumbbell
