#include "cli/commands/verify.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell {

void become_verifier(int argc, char** argv) {
    std::string program = verifier_path();
    std::vector<char*> arguments{program.data()};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    verifier_not_started(program, errno);
}

std::string verified(const std::string& file, std::string_view scene, Loudness loudness) {
    const Progress progress("", loudness, "verifying");
    // Whoever waits for it can stop it; a budget would only be in the way.
    Verdict verdict =
        ask_verifier({"--quiet", "--budget=99999h", "--scene=" + std::string(scene), "--", file});
    if (!verdict.accepts) {
        throw InputError(fmt::format("'{}' is not verified: {}", file, verdict.line));
    }
    return std::move(verdict.line);
}

}  // namespace dumbbell
