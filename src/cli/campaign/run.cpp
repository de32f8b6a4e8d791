#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/campaign.hpp"
#include "campaign/folder.hpp"
#include "campaign/local_engine.hpp"
#include "campaign/password.hpp"
#include "campaign/run_report.hpp"
#include "campaign/work_queue_engine.hpp"
#include "campaign/worker_commands.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/ratio_argument.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* run_description = R"(Process what is not yet finished of a campaign.

The same command goes on after it was stopped or killed.

Examples:
  dumbbell campaign run stairs.campaign                 on all cores of this machine
  dumbbell campaign run stairs.campaign --budget 8h     overnight
  dumbbell campaign run stairs.campaign --engine workqueue      on workers, which come and go; prints how to start one
  dumbbell campaign run stairs.campaign --engine workqueue --port 9200 --address 10.0.0.1    for a network of its own)";

constexpr std::array run_options{
    argument("FOLDER", "the campaign's folder").required(),
    Option{"--engine", "local|workqueue", "local (threads), or workqueue (workers on any machines)", "local"},
    Option{"--port", "N", "workqueue: the port that workers connect to; 0: any free one", "9123"}  // of TCP
        .from(0, 65535),
    Option{"--address", "ADDRESS",
           "workqueue: the numeric address to listen on; the standard one is for this machine only",
           "127.0.0.1"},
    Option{"--program", "PATH",
           "workqueue: this program on the workers' machines, an absolute path; without it this one is "
           "sent"},
    Option{"--verify", "arrival|merge",
           "workqueue: results are verified on arrival, here; or only looked at, and verified when merged",
           "arrival"},
    jobs_option.saying(
        "threads: of proving, or with workqueue of verifying what comes in, and of trying what it leaves "
        "undecided"),
    Option{"--shard-limit", "TIME", "a shard that takes longer is split", "10m"},
    budget_option,
    flag("--again", "try the shards again that left something undecided"),
    json_option,
    flag("--quiet", "one sentence and no progress")};

/// Says at the start, and when nobody came for a while, how to start a worker.
class WorkersWanted {
  public:
    WorkersWanted(const campaign::ManagerPlace& place, Verbosity verbosity) {
        std::array<char, 256> host{};
        ::gethostname(host.data(), host.size() - 1);
        line_ = worker_command(place, reached_as(place, host.data()));
        remark(
            fmt::format("waiting for workers at {}:{}; to start one: {}", place.address, place.port, line_));
        if (verbosity == Verbosity::normal) {
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

class ShardProgress final : public Progress {
  public:
    /// `wanted` may be null: then no workers are waited for.
    ShardProgress(Verbosity verbosity, WorkersWanted* wanted)
        : Progress("shards", verbosity, "processing"), wanted_(wanted) {}

    void wait(double seconds) override {
        if (wanted_ != nullptr) {
            wanted_->alone(seconds, *this);
        }
    }

  private:
    WorkersWanted* wanted_;
};

std::unique_ptr<campaign::Engine> engine_of(const Given& given, const campaign::CampaignFolder& folder,
                                            std::optional<WorkersWanted>& wanted) {
    if (given.text("--engine") == "local") {
        if (given.has("--port") || given.has("--address") || given.has("--program") ||
            given.has("--verify")) {
            throw InputError("--port, --address, --program and --verify are for --engine workqueue");
        }
        return std::make_unique<campaign::LocalEngine>(jobs_of(given), folder.path());
    }
    const std::string path = std::filesystem::absolute(folder.path());  // for another folder, too
    if (one_line(path) != path) {
        throw InputError(fmt::format(
            "'{}' has a character in its name that not every shell of a worker could spell: rename it",
            path));
    }
    campaign::WorkQueueOptions queue;
    queue.address = given.text("--address");
    queue.port = static_cast<int>(given.number("--port"));
    queue.program = given.text("--program");
    queue.password_file = campaign::password_file(path);
    auto engine = std::make_unique<campaign::WorkQueueEngine>(queue);
    wanted.emplace(engine->place(), verbosity_of(given));
    return engine;
}

int run_shards(const Given& given) try {
    campaign::CampaignFolder folder(given.text("FOLDER"));
    folder.lock();
    campaign::CampaignOptions how;
    how.shard_limit = parse_duration(given.text("--shard-limit"), "--shard-limit");
    if (how.shard_limit->count() <= 0) {
        throw InputError("--shard-limit must be greater than 0: no shard is done at once");
    }
    how.interrupted = deadline(budget_of(given));
    if (const std::size_t open = given.has("--again") ? withdraw_open_results(folder) : 0; open > 0) {
        remark(fmt::format("shards that left something undecided, and are tried again: {}", open));
    }
    campaign::CampaignRun done;
    {
        std::optional<WorkersWanted> wanted;
        const auto engine = engine_of(given, folder, wanted);
        how.verifiers = wanted ? jobs_of(given) : 0;
        std::optional<campaign::LocalEngine> own;
        how.own = wanted ? &own.emplace(jobs_of(given), folder.path()) : nullptr;
        how.scrutiny =
            given.text("--verify") == "arrival" ? campaign::Scrutiny::proof : campaign::Scrutiny::form;
        ShardProgress progress(verbosity_of(given), wanted ? &*wanted : nullptr);
        how.observer = &progress;
        done = run_campaign(folder, *engine, how);
    }
    fmt::print("{}", given.has("--json")    ? json_text(to_json(done, given.text("--engine")))
                     : given.has("--quiet") ? verdict(done)
                                            : to_text(done));
    if (done.left == 0) {
        return exit_done;
    }
    const std::string left = fmt::format("{} left: the same command goes on", plural(done.left, "shard"));
    if (stop_signal != 0) {
        return stopped(left);
    }
    complain(left);
    return exit_not_certified;
} catch (const campaign::ResultsDiffer& error) {  // no error of this program's, at least not surely
    complain(error.what());
    return exit_internal;
}

}  // namespace

constinit const Command campaign_run_command{"run",     one_group,   run_description,
                                             inherited, run_options, stoppable<run_shards>};

}  // namespace dumbbell::cli
