#include "file/verifier_program.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/deadline.hpp"
#include "file/descriptor.hpp"
#include "file/last_line.hpp"

namespace dumbbell {
namespace {

/// All that the child writes to its end of the pipe; it is ended if this program is asked to stop.
std::string all_said(const Descriptor& pipe, pid_t child) {
    constexpr int between_looks = 200;  // ms
    std::string text;
    std::array<char, 4096> block{};
    for (;;) {
        if (stop_signal != 0) {
            ::kill(child, SIGTERM);
        }
        pollfd waits{pipe.get(), POLLIN, 0};
        if (::poll(&waits, 1, between_looks) <= 0) {
            continue;
        }
        const ssize_t n = ::read(pipe.get(), block.data(), block.size());
        if (n > 0) {
            text.append(block.data(), static_cast<std::size_t>(n));
        } else if (n == 0 || errno != EINTR) {
            return text;
        }
    }
}

struct Run {
    std::string out;
    int code = 0;
};

/// To its end. Only a child that was waited for and exited by itself has an exit code.
Run run_to_end(std::vector<std::string> words, std::string program) {
    std::vector<char*> arguments{program.data()};
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        verifier_not_started(program, errno);
    }
    const Descriptor reading(ends[0]);
    Descriptor writing(ends[1]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, writing.get(), STDOUT_FILENO);
    // None of this program's other files: they would stay open as long as the child runs.
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    pid_t child = -1;
    const int error = ::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    writing = Descriptor();
    if (error != 0) {
        verifier_not_started(program, error);
    }
    Run run{all_said(reading, child), 0};
    int status = 0;
    pid_t ended = -1;
    do {
        ended = ::waitpid(child, &status, 0);
    } while (ended < 0 && errno == EINTR);
    if (ended != child || !WIFEXITED(status)) {
        throw NoVerdict(fmt::format("the verifier '{}' did not come to its end ({})", program,
                                    ended != child        ? std::strerror(errno)
                                    : WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status))
                                                          : "no exit code"));
    }
    run.code = WEXITSTATUS(status);
    return run;
}

}  // namespace

std::string verifier_path() {
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    return (self.parent_path() / "dumbbell-verify").string();
}

void verifier_not_started(const std::string& program, int error) {
    throw NoVerdict(fmt::format("cannot start the verifier '{}': {}", program, std::strerror(error)));
}

Verdict ask_verifier(std::vector<std::string> arguments, std::string program) {
    const Run run = run_to_end(std::move(arguments), program);
    Verdict verdict{false, std::string(last_line(run.out))};
    const bool is_open = verdict.line.starts_with("s OPEN ");  // right, but nothing is proved by it
    verdict.accepts = is_open || verdict.line.starts_with("s VERIFIED ");
    if (!verdict.line.starts_with("s ") || verdict.accepts != (run.code == (is_open ? 3 : 0))) {
        throw NoVerdict(fmt::format("the verifier '{}' gave no verdict (exit code {})", program, run.code));
    }
    return verdict;
}

std::string digest_in(const std::string& verdict) {
    constexpr std::string_view word = " sha256=";
    const std::size_t at = verdict.find(word);
    return at == std::string::npos ? "" : verdict.substr(at + word.size(), 64);
}

}  // namespace dumbbell
