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

void watch(int signal) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) {
        return;
    }
    struct sigaction action {};
    action.sa_handler = request_stop;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

int stoppable(const std::function<int()>& command) {
    watch(SIGINT);
    watch(SIGTERM);
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
