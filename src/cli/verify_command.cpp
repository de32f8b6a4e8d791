#include "cli/verify_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "arith/error.hpp"
#include "cluster/last_line.hpp"
#include "cluster/verifier_program.hpp"

namespace dumbbell {

void become_verifier(int argc, char** argv) {
    std::string program = verifier_path();
    std::vector<char*> arguments{program.data()};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    verifier_not_started(program, errno);
}

std::string verified(const std::string& file, std::string_view scene) {
    const VerifierAnswer answer = ask_verifier({"--scene=" + std::string(scene), "--", file});
    std::string verdict(last_line(answer.out));
    if (answer.code != 0) {
        throw InputError(fmt::format("'{}' is not verified: {}", file, verdict));
    }
    return verdict;
}

std::string verifier_help() { return ask_verifier({"--help"}).out; }

}  // namespace dumbbell
