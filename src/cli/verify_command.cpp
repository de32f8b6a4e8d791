#include "cli/verify_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "arith/error.hpp"

namespace dumbbell {

void become_verifier(int argc, char** argv) {
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    std::string program = (self.parent_path() / "dumbbell-verify").string();
    std::vector<char*> arguments{program.data()};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    throw InputError(fmt::format("cannot start the verifier '{}': {}", program, std::strerror(errno)));
}

}  // namespace dumbbell
