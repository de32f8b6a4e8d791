#include "campaign/campaign.hpp"

#include <fmt/core.h>

#include <deque>
#include <exception>
#include <memory>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/judges.hpp"

namespace dumbbell::campaign {
namespace {

using Clock = std::chrono::steady_clock;
using Part = CampaignFolder::Part;
using What = JournalEntry::What;

/// The number of times that a shard is tried before it is given up.
constexpr int most_attempts = 5;
constexpr std::chrono::milliseconds longest_wait(200);
constexpr std::chrono::seconds between_states(10);
/// A worker came or went, the first task is out, or none is any more.
constexpr std::chrono::seconds between_changes(1);

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run over a campaign's shards.
class Run {
  public:
    Run(CampaignFolder& folder, Engine& engine, const CampaignOptions& options)
        : folder_(folder), engine_(engine), options_(options), kind_(kind_named(folder.plan().whole.kind())) {
        require(options.verifiers == 0 || options.own != nullptr,
                "results from elsewhere, and no own engine");
        for (Part& part : folder.parts()) {
            ++all_;
            if (part.finished) {
                ++finished_;
            } else {
                waiting_.push_back({std::move(part)});
            }
        }
        if (options.verifiers > 0) {
            judges_ = std::make_unique<Judges>(kind_, folder.path(), options.verifiers, options.scrutiny);
        }
    }

    CampaignRun run() {
        log(What::begin, {}, {}, 0, folder_.plan_digest());
        try {
            while (!options_.interrupted() && has_work()) {
                step();
            }
        } catch (const std::exception& error) {
            const auto first = std::current_exception();
            try {
                log(What::end, {}, {}, 0, error.what());
            } catch (const std::exception&) {
                std::rethrow_exception(first);  // the one to hear of
            }
            throw;
        }
        log_state();
        result_.left = all_ - finished_;
        result_.seconds = seconds_since(start_);
        result_.engine = engine_.figures();
        result_.own_seconds += result_.engine.busy_seconds;
        log(What::end, {}, {}, result_.seconds, result_.left == 0 ? "complete" : "stopped");
        return result_;
    }

  private:
    struct Shard {
        Part part;
        int attempts = 0;
        bool is_unlimited = false;
    };

    /// A result that is being verified, or one that left something undecided while its shard is tried here.
    struct Arrived {
        Shard shard;
        Outcome outcome;
    };

    [[nodiscard]] bool has_work() const {
        return !waiting_.empty() || !under_way_.empty() || !arrived_.empty() || !tried_here_.empty();
    }

    void step() {
        const auto begin = Clock::now();
        submit_what_is_wanted();
        result_.own_seconds += seconds_since(begin);
        auto outcome = engine_.wait(longest_wait);
        const auto arrival = Clock::now();
        if (outcome) {
            take(std::move(*outcome));
        }
        while (auto answer = judges_ ? judges_->answer() : std::nullopt) {
            take(*answer);
        }
        while (auto own =
                   tried_here_.empty() ? std::nullopt : options_.own->wait(std::chrono::milliseconds(0))) {
            take_own(*own);
        }
        look_at_workers();
        result_.own_seconds += seconds_since(arrival);
    }

    void submit_what_is_wanted() {
        // Results that wait for their verification count: faster workers would only fill the memory.
        while (!waiting_.empty() && under_way_.size() + arrived_.size() < engine_.wanted()) {
            Shard shard = std::move(waiting_.front());
            waiting_.pop_front();
            engine_.submit(task_of(shard));
            under_way_.emplace(shard.part.id, std::move(shard));
        }
    }

    [[nodiscard]] Task task_of(const Shard& shard) const {
        Task task{shard.part.id, folder_.order(shard.part).text(), {}, {}};
        for (const std::string& input : folder_.plan().inputs) {
            task.inputs.push_back(folder_.path() + "/" + input);
        }
        if (!shard.is_unlimited) {
            task.limit = options_.shard_limit;
        }
        return task;
    }

    void take(Outcome outcome) {
        const auto found = under_way_.find(outcome.id);
        if (found == under_way_.end() || stop_signal != 0) {
            return;  // what a stopped program hears last is of no use
        }
        Shard shard = std::move(found->second);
        under_way_.erase(found);
        switch (outcome.end) {
            case Outcome::End::done:
                if (judges_) {
                    ask_judges(std::move(shard), std::move(outcome));
                } else {
                    accept(shard, outcome);
                }
                break;
            case Outcome::End::too_long:
                split(std::move(shard));
                break;
            case Outcome::End::failed:
                fail(std::move(shard), outcome, outcome.reason);
                break;
        }
    }

    void fail(Shard shard, const Outcome& outcome, const std::string& reason) {
        ++result_.failed;
        log(What::failed, shard.part.id, outcome.worker, outcome.seconds, reason);
        try_again(std::move(shard), reason);
    }

    void ask_judges(Shard shard, Outcome outcome) {
        const std::string file = folder_.arrived(shard.part.id, outcome.result);
        judges_->ask({folder_.order(shard.part), file, next_number_});
        arrived_.emplace(next_number_++, Arrived{std::move(shard), std::move(outcome)});
    }

    void take(const Judges::Answer& answer) {
        const auto found = arrived_.find(answer.number);
        Arrived arrived = std::move(found->second);
        arrived_.erase(found);
        folder_.forget_arrived(arrived.shard.part.id);
        result_.verifying += answer.seconds;
        if (stop_signal != 0) {
            return;  // the signal may have ended the verifier
        }
        using Verdict = Judgement::Verdict;
        const Judgement& judgement = answer.judgement;
        if (judgement.verdict == Verdict::none) {
            fail(std::move(arrived.shard), arrived.outcome, judgement.reason);
            return;
        }
        if (judgement.verdict == Verdict::proved) {
            accept(arrived.shard, arrived.outcome);
            return;
        }
        if (judgement.verdict == Verdict::open) {
            try_here(std::move(arrived));
            return;
        }
        reject(arrived, judgement.reason);
        try_again(std::move(arrived.shard), judgement.reason);
    }

    /// It was not what its worker's machine says that it is.
    void reject(const Arrived& arrived, const std::string& reason) {
        ++result_.rejected;
        engine_.distrust(arrived.outcome);
        folder_.reject(arrived.shard.part.id, arrived.outcome.result);
        log(What::rejected, arrived.shard.part.id, arrived.outcome.worker, arrived.outcome.seconds, reason);
    }

    /// A result may leave a shard undecided because it cannot be decided, or because nobody tried. While this
    /// program has enough to try, others may.
    void try_here(Arrived arrived) {
        if (tried_here_.size() >= options_.own->wanted()) {
            waiting_.push_back(std::move(arrived.shard));
            return;
        }
        options_.own->submit(task_of(arrived.shard));
        tried_here_.emplace(arrived.shard.part.id, std::move(arrived));
    }

    /// What was tried here after an answer that left something undecided.
    void take_own(const Outcome& own) {
        const auto found = tried_here_.find(own.id);
        if (found == tried_here_.end() || stop_signal != 0) {
            return;
        }
        Arrived answer = std::move(found->second);
        tried_here_.erase(found);
        if (own.end == Outcome::End::too_long) {
            split(std::move(answer.shard));
            return;
        }
        if (own.end == Outcome::End::failed) {
            fail(std::move(answer.shard), own, own.reason);
            return;
        }
        accept(answer.shard, own);
        const Judgement judgement = kind_.judge(folder_.order(answer.shard.part), folder_.path(),
                                                folder_.result_file(own.id), Scrutiny::form);
        if (judgement.verdict == Judgement::Verdict::open) {
            options_.observer->note(fmt::format("shard {}: {}, here too", own.id, judgement.reason));
        } else {
            reject(answer, "it left undecided what this machine decides");
        }
    }

    void accept(const Shard& shard, const Outcome& outcome) {
        using Kept = CampaignFolder::Kept;
        const Kept kept = folder_.keep_result(shard.part.id, outcome.result);
        if (kept == Kept::other) {
            choose(shard, outcome);
        }
        log(kept == Kept::now ? What::done : What::again, shard.part.id, outcome.worker, outcome.seconds, "");
        ++(kept == Kept::now ? result_.accepted : result_.again);
        result_.worked += outcome.seconds;
        ++finished_;
        options_.observer->update(finished_, all_, std::nullopt);
    }

    /// There is another result, and proofs of one statement may differ: the first one that proves it is kept,
    /// the other one in `rejected`. A worker's word has no proof.
    void choose(const Shard& shard, const Outcome& outcome) {
        const std::string& id = shard.part.id;
        if (kind_.evidence() == Evidence::workers) {
            folder_.reject(id, outcome.result);
            throw ResultsDiffer(
                fmt::format("two results of one shard differ: '{}' and '{}/rejected/{}'; one of the "
                            "machines, or its program, is not to be relied on: find out which, move the "
                            "first file elsewhere if it is not a true one, and run the campaign again",
                            folder_.result_file(id), folder_.path(), id));
        }
        const Judgement first =
            kind_.judge(folder_.order(shard.part), folder_.path(), folder_.result_file(id), Scrutiny::proof);
        using Verdict = Judgement::Verdict;
        const bool stays = first.verdict == Verdict::proved || first.verdict == Verdict::none;
        if (stays) {
            folder_.reject(id, outcome.result);
        } else {
            folder_.withdraw_result(id);
            (void)folder_.keep_result(id, outcome.result);
        }
        options_.observer->note(
            fmt::format("shard {} has two results that differ: the {} is kept, the other one is in "
                        "'{}/rejected'",
                        id, stays ? "first" : "second", folder_.path()));
    }

    void split(Shard shard) {
        if (shard.part.end - shard.part.first < 2) {
            shard.is_unlimited = true;
            waiting_.push_back(std::move(shard));
            return;
        }
        folder_.split(shard.part.id);
        ++result_.split;
        log(What::split, shard.part.id, {}, 0, "");
        ++all_;
        for (Part& half : folder_.halves(shard.part)) {
            waiting_.push_front({std::move(half)});
        }
        options_.observer->update(finished_, all_, std::nullopt);
    }

    void try_again(Shard shard, const std::string& reason) {
        if (++shard.attempts < most_attempts) {
            waiting_.push_back(std::move(shard));
            return;
        }
        ++result_.given_up;
        options_.observer->note(fmt::format("shard {} is given up after {} attempts: {}", shard.part.id,
                                            most_attempts, printable(reason, 200)));
    }

    void look_at_workers() {
        const auto now = Clock::now();
        const EngineFigures figures = engine_.figures();
        const bool differs =
            figures.workers != last_figures_.workers || (figures.running > 0) != (last_figures_.running > 0);
        if (now - last_state_ >= (differs ? between_changes : between_states)) {
            log_state();
        }
        if (figures.workers > 0) {
            last_company_ = now;
        } else {
            options_.observer->wait(seconds_since(last_company_));
        }
    }

    void log_state() {
        last_state_ = Clock::now();
        const EngineFigures f = last_figures_ = engine_.figures();
        log(What::state, {}, {}, seconds_since(start_),
            fmt::format("workers={} running={} joined={} lost={} resent={} busy={:.3f}", f.workers, f.running,
                        f.joined, f.lost, f.resent, f.busy_seconds));
    }

    void log(What what, const std::string& id, const std::string& worker, double seconds,
             const std::string& text) {
        folder_.journal().append({0, what, id, worker, seconds, text});
    }

    CampaignFolder& folder_;
    Engine& engine_;
    const CampaignOptions& options_;
    const Kind& kind_;
    std::unique_ptr<Judges> judges_;
    std::deque<Shard> waiting_;
    std::map<std::string, Shard> under_way_;
    std::map<std::size_t, Arrived> arrived_;
    std::map<std::string, Arrived> tried_here_;
    std::size_t next_number_ = 0;
    std::size_t all_ = 0;
    std::size_t finished_ = 0;
    CampaignRun result_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point last_state_{};  ///< long ago
    EngineFigures last_figures_;
    Clock::time_point last_company_ = start_;
};

}  // namespace

std::size_t withdraw_open_results(const CampaignFolder& folder) {
    const Kind& kind = kind_named(folder.plan().whole.kind());
    std::size_t withdrawn = 0;
    for (const Part& part : folder.parts()) {
        const auto is_open = [&] {
            return kind.judge(folder.order(part), folder.path(), folder.result_file(part.id), Scrutiny::form)
                       .verdict == Judgement::Verdict::open;
        };
        if (part.finished && is_open()) {
            folder.withdraw_result(part.id);
            ++withdrawn;
        }
    }
    return withdrawn;
}

CampaignRun run_campaign(CampaignFolder& folder, Engine& engine, const CampaignOptions& options) {
    return Run(folder, engine, options).run();
}

}  // namespace dumbbell::campaign
