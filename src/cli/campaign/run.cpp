#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "campaign/campaign.hpp"
#include "campaign/folder.hpp"
#include "campaign/local_engine.hpp"
#include "campaign/password.hpp"
#include "campaign/run_report.hpp"
#include "campaign/work_queue_engine.hpp"
#include "campaign/worker_commands.hpp"
#include "cli/campaign/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/ratio_argument.hpp"
#include "words/json_number.hpp"
#include "words/printed.hpp"

namespace dumbbell {
namespace {

constexpr const char* description = R"(Work off what is not finished of a campaign.

The same command goes on after it was stopped or killed.

Examples:
  dumbbell campaign run stairs.campaign                 on all cores of this machine
  dumbbell campaign run stairs.campaign --budget 8h     overnight
  dumbbell campaign run stairs.campaign --engine workqueue      on workers, which come and go; prints how to start one
  dumbbell campaign run stairs.campaign --engine workqueue --port 9200 --address 10.0.0.1    for a network of its own)";

struct Options {
    std::string folder;
    std::string engine = "local";
    std::string budget;
    std::string shard_limit = "10m";
    std::string verify = "arrival";
    WorkQueueOptions queue;
    bool has_queue_options = false;
    int jobs = all_cores();
    bool again = false;
    bool json = false;
    bool quiet = false;
};

/// Says at the start, and when nobody came for a while, how to start a worker.
class WorkersWanted {
  public:
    WorkersWanted(const ManagerPlace& place, Loudness loudness)
        : line_(worker_command(place, place.address)) {
        std::array<char, 256> host{};
        ::gethostname(host.data(), host.size() - 1);
        remark(
            fmt::format("waiting for workers at {}:{}; to start one: {}", place.address, place.port, line_));
        if (loudness == Loudness::normal) {
            say(worker_examples(place, host.data()));
        }
    }

    void alone(double seconds, Progress& progress) {
        if (seconds < next_) {
            next_ = seconds < first ? first : next_;  // somebody was there
            return;
        }
        progress.note(fmt::format("no worker for {}; to start one: {}", time_text(seconds), line_));
        next_ = seconds + between;
    }

  private:
    static constexpr double first = 60;  // seconds
    static constexpr double between = 600;

    std::string line_;
    double next_ = first;
};

std::unique_ptr<Engine> engine_of(const Options& options, const CampaignFolder& folder,
                                  std::optional<WorkersWanted>& wanted) {
    if (options.engine == "local") {
        if (options.has_queue_options) {
            throw InputError("--port, --address, --program and --verify are for --engine workqueue");
        }
        return std::make_unique<LocalEngine>(options.jobs, folder.path());
    }
    WorkQueueOptions queue = options.queue;
    queue.password_file = password_file(std::filesystem::absolute(folder.path()));  // for another folder, too
    auto engine = std::make_unique<WorkQueueEngine>(queue);
    wanted.emplace(engine->place(), options.quiet ? Loudness::quiet : Loudness::normal);
    return engine;
}

int run(const Options& options) {
    CampaignFolder folder(options.folder);
    folder.lock();
    CampaignOptions how;
    how.shard_limit = parse_duration(options.shard_limit, "--shard-limit");
    if (how.shard_limit->count() <= 0) {
        throw InputError("--shard-limit must be greater than 0: no shard is done at once");
    }
    how.interrupted =
        deadline(options.budget.empty() ? std::nullopt : std::optional(parse_duration(options.budget)));
    if (const std::size_t open = options.again ? withdraw_open_results(folder) : 0; open > 0) {
        remark(fmt::format("shards that left something undecided, and are tried again: {}", open));
    }
    CampaignRun done;
    {
        std::optional<WorkersWanted> wanted;
        const auto engine = engine_of(options, folder, wanted);
        how.verifiers = wanted ? options.jobs : 0;
        std::optional<LocalEngine> own;
        how.own = wanted ? &own.emplace(options.jobs, folder.path()) : nullptr;
        how.scrutiny = options.verify == "arrival" ? Scrutiny::proof : Scrutiny::form;
        Progress progress("shards", options.quiet ? Loudness::quiet : Loudness::normal);
        how.progress = [&](std::size_t finished, std::size_t all) { progress.update(finished, all); };
        how.note = [&](const std::string& line) { progress.note(line); };
        how.lonely = [&](double seconds) { wanted ? wanted->alone(seconds, progress) : void(); };
        done = run_campaign(folder, *engine, how);
    }
    if (options.json) {
        fmt::print("{}", json_text(to_json(done, options.engine)));
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
    const auto of_queue = [options](const std::string& /*value*/) {
        options->has_queue_options = true;
        return std::string();
    };
    command
        ->add_option("--port", options->queue.port,
                     "workqueue: the port that workers connect to; 0: any free one")
        ->check(CLI::Range(0, 65535))
        ->check(of_queue)
        ->capture_default_str();
    command
        ->add_option("--address", options->queue.address,
                     "workqueue: the numeric address to listen on; the standard one is for this machine only")
        ->check(of_queue)
        ->type_name("ADDRESS")
        ->capture_default_str();
    command
        ->add_option(
            "--program", options->queue.program,
            "workqueue: this program on the workers' machines, an absolute path; without it this one is sent")
        ->check(of_queue)
        ->type_name("PATH");
    command
        ->add_option(
            "--verify", options->verify,
            "workqueue: results are verified on arrival, here; or only looked at, and verified when merged")
        ->check(CLI::IsMember({"arrival", "merge"}))
        ->check(of_queue)
        ->capture_default_str();
    add_jobs_option(
        *command, options->jobs,
        "threads: of proving, or with workqueue of verifying what comes in, and of trying what it "
        "leaves undecided");
    command->add_option("--shard-limit", options->shard_limit, "a shard that takes longer is split")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_option("--budget", options->budget, "stop after this time: 30s, 10m, 2h")->type_name("TIME");
    command->add_flag("--again", options->again, "try the shards again that left something undecided");
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "one sentence and no progress");
    command->callback([options, &exit_code] {
        try {
            exit_code = stoppable([&] { return run(*options); });
        } catch (const ResultsDiffer& error) {  // no error of this program's, at least not surely
            complain(error.what());
            exit_code = exit_internal;
        }
    });
}

}  // namespace dumbbell
