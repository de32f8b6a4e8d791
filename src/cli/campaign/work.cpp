#include <fmt/core.h>
#include <sys/prctl.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "campaign/kind.hpp"
#include "cli/commands.hpp"
#include "cli/options/given.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "number/ratio_argument.hpp"
#include "number/self_test.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* work_description =
    "Work one order off (a worker does; nobody types this). It ends with 0 if the result is there, with 3 if "
    "not within the limit.";

constexpr std::array work_options{argument("ORDER", "file with the order").required(),
                                  argument("RESULT", "file to write").required(),
                                  Option{"--limit", "SECONDS", "how long it may take"}};

/// --limit, if it was given.
std::optional<std::chrono::duration<double>> limit_of(const Given& given) {
    return given.has("--limit") ? std::optional(parse_duration(given.text("--limit") + "s", "--limit"))
                                : std::nullopt;
}

int run_work(const Given& given) {
    // A worker that gives a task up ends the shell that waits for this program, and nothing else.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    require_sound_arithmetic();
    const campaign::Order order = campaign::parse_order(file_contents(given.text("ORDER")));
    const auto folder = std::filesystem::absolute(given.text("ORDER")).parent_path().string();
    const auto limit = limit_of(given);
    const AtomicFile file(given.text("RESULT"));
    const auto result = campaign::kind_named(order.kind()).work(order, folder, deadline(limit));
    if (!result) {
        return stop_signal != 0 ? exit_stopped : exit_not_certified;
    }
    file.commit(*result, Survives::program);
    return exit_done;
}

}  // namespace

constinit const Command campaign_work_command{"work",    "",           work_description,
                                              inherited, work_options, stoppable<run_work>};

}  // namespace dumbbell::cli
