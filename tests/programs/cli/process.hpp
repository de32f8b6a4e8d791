// Runs the built programs and sees what a user or a script sees: stdout, stderr, exit code.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "temporary_folder.hpp"

namespace dumbbell_test {

struct Outcome {
    int code;  // the exit code, or -1 if a signal ended the program
    int signal;
    std::string out;
    std::string err;
    double cpu_seconds = 0;  // all its threads together: however busy the machine is
};

// A running program with its stdout and stderr in pipes. Ended with SIGKILL if nobody waits for it.
class Process {
  public:
    explicit Process(std::vector<std::string> command, const std::string& folder = ".") {
        std::array<std::array<int, 2>, 2> pipes{};
        for (auto& pipe : pipes) {
            if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
                throw std::runtime_error("no pipe");
            }
        }
        std::vector<char*> arguments;
        for (std::string& word : command) {
            arguments.push_back(word.data());
        }
        arguments.push_back(nullptr);
        pid_ = ::fork();
        if (pid_ == 0) {
            ::dup2(pipes[0][1], STDOUT_FILENO);
            ::dup2(pipes[1][1], STDERR_FILENO);
            ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
            if (::chdir(folder.c_str()) == 0) {
                ::execvp(arguments[0], arguments.data());
            }
            ::_exit(127);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            ::close(pipes[i][1]);
            read_end_[i] = pipes[i][0];
        }
        if (pid_ < 0) {
            throw std::runtime_error("cannot fork");
        }
    }
    ~Process() {
        if (pid_ > 0) {
            kill();
            ::waitpid(pid_, nullptr, 0);
        }
        ::close(read_end_[0]);
        ::close(read_end_[1]);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void kill() const { send(SIGKILL); }
    void send(int signal) const { ::kill(pid_, signal); }

    // Of the processor's time, so far.
    [[nodiscard]] double cpu_seconds() const {
        clockid_t clock{};
        timespec time{};
        if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) {
            return 0;
        }
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    [[nodiscard]] bool ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
               info.si_pid == pid_;
    }

    // Waits until the condition holds, or the program has ended; whether the condition holds then.
    template <class Condition>
    bool until(Condition holds) const {
        while (!holds()) {
            if (ended()) {
                return holds();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }

    Outcome wait() {
        Outcome result{-1, 0, "", ""};
        read_all(result.out, result.err);
        int status = 0;
        rusage used{};
        while (::wait4(pid_, &status, 0, &used) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        for (const timeval& part : {used.ru_utime, used.ru_stime}) {
            result.cpu_seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
        }
        result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        return result;
    }

  private:
    void read_all(std::string& out, std::string& err) const {
        std::array<std::string*, 2> texts{&out, &err};
        std::array<pollfd, 2> ends{pollfd{read_end_[0], POLLIN, 0}, pollfd{read_end_[1], POLLIN, 0}};
        std::array<char, 65536> buffer{};
        while (ends[0].fd >= 0 || ends[1].fd >= 0) {
            ::poll(ends.data(), ends.size(), -1);
            for (std::size_t i = 0; i < 2; ++i) {
                if (ends[i].fd < 0 || ends[i].revents == 0) {
                    continue;
                }
                const ssize_t n = ::read(ends[i].fd, buffer.data(), buffer.size());
                if (n > 0) {
                    texts[i]->append(buffer.data(), static_cast<std::size_t>(n));
                } else if (n == 0 || errno != EINTR) {
                    ends[i].fd = -1;
                }
            }
        }
    }

    pid_t pid_ = -1;
    std::array<int, 2> read_end_{};
};

inline Outcome run(std::vector<std::string> command, const std::string& folder = ".") {
    return Process(std::move(command), folder).wait();
}

// `text` with its one occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) {
        throw std::runtime_error("not exactly once in the text: " + from);
    }
    return text.replace(at, from.size(), to);
}

inline long count_lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace dumbbell_test
