#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "cli/campaign_commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/messages.hpp"
#include "cli/progress.hpp"
#include "cli/ratio_argument.hpp"
#include "cli/stop_signals.hpp"
#include "cluster/campaign.hpp"
#include "cluster/local_engine.hpp"
#include "cluster/run_report.hpp"
#include "prove/deadline.hpp"

namespace dumbbell {
namespace {

constexpr const char* description = R"(Work off what is not finished of a campaign.

The same command goes on after it was stopped or killed.

Examples:
  dumbbell campaign run stairs.campaign                 on all cores of this machine
  dumbbell campaign run stairs.campaign --budget 8h     overnight)";

struct Options {
    std::string folder;
    std::string engine = "local";
    std::string budget;
    std::string shard_limit = "10m";
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    bool json = false;
    bool quiet = false;
};

int run(const Options& options) {
    CampaignFolder folder(options.folder);
    folder.lock();
    CampaignOptions how;
    how.shard_limit = parse_duration(options.shard_limit);
    how.interrupted =
        deadline(options.budget.empty() ? std::nullopt : std::optional(parse_duration(options.budget)));
    CampaignRun done;
    {
        LocalEngine engine(options.jobs, folder.path());
        Progress progress("shards", options.quiet ? Loudness::quiet : Loudness::normal);
        how.progress = [&](std::size_t finished, std::size_t all) { progress.update(finished, all); };
        how.note = [&](const std::string& line) { progress.note(line); };
        done = run_campaign(folder, engine, how);
    }
    if (options.json) {
        fmt::print("{}\n", to_json(done, options.engine).dump(2));
    } else {
        fmt::print("{}", options.quiet ? verdict(done) : to_text(done));
    }
    if (done.left == 0) {
        return exit_done;
    }
    const bool stopped = stop_signal != 0;
    complain(fmt::format("{}{} shards are left: the same command goes on with them",
                         stopped ? stopped_by() + ": " : "", done.left));
    return stopped ? exit_stopped : exit_not_certified;
}

}  // namespace

void add_campaign_run(CLI::App& campaign, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = campaign.add_subcommand("run", description);
    command->add_option("FOLDER", options->folder, "the campaign's folder")->required();
    command
        ->add_option("--engine", options->engine, "local (threads), or workqueue (workers on any machines)")
        ->check(CLI::IsMember({"local", "workqueue"}))
        ->capture_default_str();
    command->add_option("--jobs", options->jobs, "threads; the result does not depend on it")
        ->check(CLI::Range(1, 1024))
        ->default_str("all cores");
    command->add_option("--shard-limit", options->shard_limit, "a shard that takes longer is split")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_option("--budget", options->budget, "stop after this time: 30s, 10m, 2h")->type_name("TIME");
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "one sentence and no progress");
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return run(*options); }); });
}

}  // namespace dumbbell
