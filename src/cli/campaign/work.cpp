#include <fmt/format.h>
#include <sys/prctl.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "campaign/kind.hpp"
#include "cli/campaign/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "number/self_test.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    "Work one order off (a worker does; nobody types this). It ends with 0 if the result is there, with 3 if "
    "not within the limit.";

struct Options {
    std::string order;
    std::string result;
    std::optional<double> limit;
};

int work(const Options& options) {
    // A worker that gives a task up ends the shell that waits for this program, and nothing else.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    require_sound_arithmetic();
    const Order order = parse_order(file_contents(options.order));
    const auto folder = std::filesystem::absolute(options.order).parent_path().string();
    const auto limit =
        options.limit ? std::optional(std::chrono::duration<double>(*options.limit)) : std::nullopt;
    const AtomicFile file(options.result);
    const auto result = kind_named(order.kind()).work(order, folder, deadline(limit));
    if (!result) {
        return stop_signal != 0 ? exit_stopped : exit_not_certified;
    }
    file.commit(*result, Survives::program);
    return exit_done;
}

}  // namespace

void add_campaign_work(CLI::App& campaign, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = campaign.add_subcommand("work", description);
    command->group("");  // hidden
    command->add_option("ORDER", options->order, "file with the order")->required();
    command->add_option("RESULT", options->result, "file to write")->required();
    command->add_option("--limit", options->limit, "seconds")->check(CLI::Range(0.0, 1e9));
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return work(*options); }); });
}

}  // namespace dumbbell
