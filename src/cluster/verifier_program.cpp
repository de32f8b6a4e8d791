#include "cluster/verifier_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "arith/error.hpp"

namespace dumbbell {
namespace {

/// All that comes out of the pipe's end, which is closed.
std::string read_to_end(int descriptor) {
    std::string text;
    std::array<char, 4096> block{};
    for (;;) {
        const ssize_t n = ::read(descriptor, block.data(), block.size());
        if (n > 0) {
            text.append(block.data(), static_cast<std::size_t>(n));
        } else if (n == 0 || errno != EINTR) {
            ::close(descriptor);
            return text;
        }
    }
}

}  // namespace

std::string verifier_path() {
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    return (self.parent_path() / "dumbbell-verify").string();
}

void verifier_not_started(const std::string& program, int error) {
    throw InputError(fmt::format("cannot start the verifier '{}': {}", program, std::strerror(error)));
}

VerifierAnswer ask_verifier(std::vector<std::string> words, std::string program) {
    std::vector<char*> arguments{program.data()};
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        verifier_not_started(program, errno);
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    pid_t child = -1;
    const int error = ::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    VerifierAnswer answer{read_to_end(pipe[0]), -1};
    if (error != 0) {
        verifier_not_started(program, error);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return answer;
}

}  // namespace dumbbell
