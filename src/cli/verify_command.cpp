#include "cli/verify_command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "arith/error.hpp"

namespace dumbbell {
namespace {

std::string verifier() {
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    return (self.parent_path() / "dumbbell-verify").string();
}

[[noreturn]] void not_started(const std::string& program, int error) {
    throw InputError(fmt::format("cannot start the verifier '{}': {}", program, std::strerror(error)));
}

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

std::string last_line(std::string text) {
    while (text.ends_with('\n')) {
        text.pop_back();
    }
    return text.substr(text.rfind('\n') + 1);
}

/// What a run of the verifier printed, and its exit code, or -1 if it did not come to its end.
struct Answer {
    std::string out;
    int code;
};

Answer ask_verifier(std::vector<std::string> words) {
    std::string program = verifier();
    std::vector<char*> arguments{program.data()};
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        not_started(program, errno);
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    pid_t child = -1;
    const int error = ::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    Answer answer{read_to_end(pipe[0]), -1};
    if (error != 0) {
        not_started(program, error);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return answer;
}

}  // namespace

void become_verifier(int argc, char** argv) {
    std::string program = verifier();
    std::vector<char*> arguments{program.data()};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    not_started(program, errno);
}

std::string verified(const std::string& file, std::string_view scene) {
    const Answer answer = ask_verifier({"--scene=" + std::string(scene), "--", file});
    const std::string verdict = last_line(answer.out);
    if (answer.code != 0) {
        throw InputError(fmt::format("'{}' is not verified: {}", file, verdict));
    }
    return verdict;
}

std::string verifier_help() { return ask_verifier({"--help"}).out; }

}  // namespace dumbbell
