#include "cli/terminal/stop_signals.hpp"

#include <fmt/core.h>

#include <csignal>
#include <cstdio>

#include "base/deadline.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"

namespace dumbbell::cli {
namespace {

extern "C" void request_stop(int signal) { stop_signal = signal; }

/// As long as it lives, a signal is a request.
class Watch {
  public:
    explicit Watch(int signal) : signal_(signal) {
        ::sigaction(signal_, nullptr, &before_);
        if (before_.sa_handler == SIG_IGN) {
            return;
        }
        struct sigaction action {};
        action.sa_handler = request_stop;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        ::sigaction(signal_, &action, nullptr);
    }
    ~Watch() { ::sigaction(signal_, &before_, nullptr); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

  private:
    int signal_;
    struct sigaction before_ {};
};

}  // namespace

int stoppable(const std::function<int()>& command) {
    const Watch interrupt(SIGINT), terminate(SIGTERM);
    const int code = command();
    if (code == exit_stopped) {
        const int signal = stop_signal;
        std::fflush(nullptr);
        ::signal(signal, SIG_DFL);
        ::raise(signal);
        return exit_stopped + signal;  // the first process of a container does not end by a signal
    }
    return code;
}

int stopped(const std::string& what) {
    complain(fmt::format("stopped by {}: {}", stop_signal == SIGINT ? "SIGINT" : "SIGTERM", what));
    return exit_stopped;
}

}  // namespace dumbbell::cli
