#pragma once

#include <functional>
#include <string>

#include "cli/options/given.hpp"

namespace dumbbell::cli {

/// Runs a command that SIGINT and SIGTERM only ask to stop (base/deadline.hpp): it ends early and says what
/// is kept. Where its exit code then is exit_stopped the program ends by that signal, so that a shell sees
/// what it expects (exit code 130 or 143, and a loop that ends). A second signal ends the program at once,
/// and one that was ignored when it began stays ignored.
int stoppable(const std::function<int()>& command);
template <int (*run)(const Given&)>
int stoppable(const Given& given) {
    return stoppable([&] { return run(given); });
}

/// Says that a signal stopped the command, and `what` that means; returns exit_stopped.
[[nodiscard]] int stopped(const std::string& what);

}  // namespace dumbbell::cli
