// bench_campaign simulated SHARDS: a campaign of SHARDS small shards with an engine that loses workers,
// returns garbage and is killed now and then. bench_campaign tasks NUMBER SECONDS CORES: NUMBER tasks that
// only sleep, on a worker that claims CORES cores. Both print a JSON object.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <thread>

#include "campaign/campaign.hpp"
#include "campaign/local_engine.hpp"
#include "campaign/merge.hpp"
#include "campaign/password.hpp"
#include "campaign/plan.hpp"
#include "campaign/work_queue_engine.hpp"
#include "file/verifier_program.hpp"
#include "number/rational.hpp"

namespace {

using namespace dumbbell;
using namespace dumbbell::campaign;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double peak_megabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "dumbbell-bench-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~Scratch() { fs::remove_all(path_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Pieces of [2, 4], where N* = 3: two to a shard.
Plan many_pieces(std::size_t shards) {
    const std::size_t pieces = 2 * shards;
    Plan plan{"certify 2/1:4/1 --gap 0, in very many pieces",
              {"prove collisions\nlemmas 1\nscene dumbbell\nsection turning\n", {}},
              {},
              {}};
    const auto end = [&](std::size_t i) { return to_fraction(Rational(2) + Rational(2 * i, pieces)); };
    for (std::size_t i = 0; i < pieces; ++i) {
        plan.whole.units.push_back(fmt::format("piece {} {} 3 3", end(i), end(i + 1)));
    }
    plan.shards = even_shards(std::vector<std::size_t>(pieces, 1), shards);
    return plan;
}

/// Works tasks off here, in random order, with random misfortunes.
class UnluckyEngine : public Engine {
  public:
    struct Misfortunes {
        std::size_t lost = 0, garbage = 0, too_long = 0;
    };
    UnluckyEngine(std::mt19937& random, Misfortunes& misfortunes)
        : random_(random), misfortunes_(misfortunes) {}

    void submit(const Task& task) override { tasks_.push_back(task); }
    std::optional<campaign::Outcome> wait(std::chrono::milliseconds time) override {
        if (tasks_.empty()) {
            std::this_thread::sleep_for(std::min(time, std::chrono::milliseconds(1)));
            return std::nullopt;
        }
        std::swap(tasks_[random_() % tasks_.size()], tasks_.back());
        const Task task = std::move(tasks_.back());
        tasks_.pop_back();
        ++outcomes_;
        return outcome_of(task);
    }
    void distrust(const campaign::Outcome& /*outcome*/) override {}
    [[nodiscard]] std::size_t wanted() const override { return 200; }
    [[nodiscard]] EngineFigures figures() const override {
        EngineFigures figures;
        figures.workers = 1;
        return figures;
    }
    [[nodiscard]] std::size_t outcomes() const { return outcomes_; }

  private:
    campaign::Outcome outcome_of(const Task& task) {
        campaign::Outcome outcome{task.id, campaign::Outcome::End::failed, {}, "worker lost", "simulated", 0};
        const auto luck = random_() % 1000;
        if (luck < 20) {
            ++misfortunes_.lost;
            return outcome;
        }
        if (luck < 25 && task.limit) {
            ++misfortunes_.too_long;
            outcome.end = campaign::Outcome::End::too_long;
            return outcome;
        }
        const Order order = parse_order(task.order);
        outcome.end = campaign::Outcome::End::done;
        outcome.result = *kind_named(order.kind()).work(order, ".", never);
        if (luck < 35) {
            ++misfortunes_.garbage;
            outcome.result[random_() % outcome.result.size()] ^= 1;
        }
        return outcome;
    }

    std::mt19937& random_;
    Misfortunes& misfortunes_;
    std::vector<Task> tasks_;
    std::size_t outcomes_ = 0;
};

std::size_t unfinished(const CampaignFolder& folder) {
    const auto parts = folder.parts();
    return static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(), [](const auto& part) { return !part.finished; }));
}

Json simulated(std::size_t shards) {
    const Scratch scratch;
    const std::string place = (scratch.path() / "campaign").string();
    const auto start = Clock::now();
    CampaignFolder::create(place, many_pieces(shards));
    Json json{{"shards", shards}, {"plan_seconds", seconds_since(start)}};

    std::mt19937 random(1);
    UnluckyEngine::Misfortunes misfortunes;
    CampaignRun all;
    std::size_t runs = 0;
    for (bool complete = false; !complete;) {
        CampaignFolder folder(place);  // as a new program does
        folder.lock();
        UnluckyEngine engine(random, misfortunes);
        const std::size_t killed_after = shards / 8 + random() % (shards / 8 + 1);
        CampaignOptions options;
        options.shard_limit = std::chrono::minutes(1);
        LocalEngine own(1, place);
        options.verifiers = 1;
        options.own = &own;
        options.scrutiny =
            Scrutiny::form;  // starting the verifier 100,000 times would be all that is measured
        options.interrupted = [&] { return engine.outcomes() >= killed_after; };
        const CampaignRun run = run_campaign(folder, engine, options);
        ++runs;
        all.accepted += run.accepted;
        all.rejected += run.rejected;
        all.seconds += run.seconds;
        all.own_seconds += run.own_seconds;
        complete = unfinished(folder) == 0;
    }
    json["programs"] = runs;
    json["workers_lost"] = misfortunes.lost;
    json["garbage"] = misfortunes.garbage;
    json["rejected"] = all.rejected;
    json["split"] = misfortunes.too_long;
    json["run_seconds"] = all.seconds;
    json["manager_ms_a_shard"] = 1000 * all.own_seconds / static_cast<double>(shards);

    const CampaignFolder folder(place);
    json["parts"] = folder.parts().size();
    json["accepted"] = all.accepted;
    const auto merging = Clock::now();
    const Merge merge = merge_campaign(folder, {.scrutiny = Scrutiny::form});
    json["merge_seconds"] = seconds_since(merging);
    json["merged"] = merge.whole.has_value();
    json["bytes"] = merge.whole ? merge.whole->text.size() : 0;
    json["peak_megabytes"] = peak_megabytes();
    if (merge.whole) {
        const std::string file = (scratch.path() / "whole.dbc").string();
        std::ofstream(file) << merge.whole->text;
        json["verified"] = ask_verifier({"--quiet", "--ratio=2:4", "--exactly=3", "--", file}).accepts;
    }
    return json;
}

constexpr const char* sleeper = R"sh(#!/bin/sh
for last; do before=$order; order=$last; done
sleep "$(cat "$before")"
echo slept > "$last"
)sh";

Json tasks(int number, const std::string& seconds, const std::string& cores) {
    const Scratch scratch;
    const std::string program = (scratch.path() / "sleeper").string();
    std::ofstream(program) << sleeper;
    ::chmod(program.c_str(), 0755);
    WorkQueueOptions options;
    options.port = 0;
    options.password_file = password_file(scratch.path().string());
    options.program = program;
    WorkQueueEngine engine(options);

    const std::string port = std::to_string(engine.port());
    std::vector<std::string> words{"work_queue_worker",
                                   "--password",
                                   options.password_file,
                                   "--cores",
                                   cores,
                                   "--timeout",
                                   "60",
                                   "--workdir",
                                   scratch.path().string(),
                                   "127.0.0.1",
                                   port};
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t silent;
    posix_spawn_file_actions_init(&silent);
    for (const int descriptor : {1, 2}) {
        posix_spawn_file_actions_addopen(&silent, descriptor, "/dev/null", O_WRONLY, 0);
    }
    pid_t worker = -1;
    if (::posix_spawnp(&worker, words[0].c_str(), &silent, nullptr, arguments.data(), environ) != 0) {
        throw std::runtime_error("no work_queue_worker: .ci/install test");
    }
    posix_spawn_file_actions_destroy(&silent);

    const auto start = Clock::now();
    int done = 0;
    for (int given = 0; done < number;) {
        for (; given < number && given < done + 4 * std::stoi(cores); ++given) {
            engine.submit({std::to_string(given), seconds + "\n", {}, {}});
        }
        done += engine.wait(std::chrono::seconds(5)) ? 1 : 0;
    }
    const double time = seconds_since(start);
    const double busy = engine.figures().busy_seconds;
    ::kill(worker, SIGKILL);
    ::waitpid(worker, nullptr, 0);
    return {{"tasks", number},
            {"sleep_seconds", seconds},
            {"worker_cores", cores},
            {"seconds", time},
            {"tasks_a_second", number / time},
            {"manager_ms_a_task", 1000 * busy / number},
            {"manager_limit_tasks_a_second", number / busy}};
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    Json json;
    if (words.size() == 2 && words[0] == "simulated") {
        json = simulated(std::stoul(words[1]));
    } else if (words.size() == 4 && words[0] == "tasks") {
        json = tasks(std::stoi(words[1]), words[2], words[3]);
    } else {
        fmt::print(stderr, "usage: bench_campaign simulated SHARDS | tasks NUMBER SECONDS CORES\n");
        return 2;
    }
    fmt::print("{}\n", json.dump(2));
    return 0;
}
