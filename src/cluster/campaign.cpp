#include "cluster/campaign.hpp"

#include <fmt/format.h>

#include <deque>
#include <exception>
#include <memory>
#include <utility>

#include "arith/printable.hpp"
#include "cluster/judges.hpp"
#include "prove/deadline.hpp"

namespace dumbbell {
namespace {

using Clock = std::chrono::steady_clock;
using Part = CampaignFolder::Part;
using What = Event::What;

/// So often a shard is tried before it is given up.
constexpr int most_attempts = 5;
/// So often a result leaves a piece undecided before it is believed that the piece stays so.
constexpr int most_open_answers = 2;
constexpr std::chrono::milliseconds patience(200);
constexpr std::chrono::seconds between_states(10);

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run over a campaign's shards.
class Run {
  public:
    Run(CampaignFolder& folder, Engine& engine, const CampaignOptions& options)
        : folder_(folder), engine_(engine), options_(options) {
        for (Part& part : folder.parts()) {
            ++all_;
            if (part.finished) {
                ++finished_;
            } else {
                waiting_.push_back({std::move(part)});
            }
        }
        if (options.verifiers > 0) {
            judges_ = std::make_unique<Judges>(kind_named(folder.plan().whole.kind()), folder.path(),
                                               options.verifiers, options.scrutiny);
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
        int open_answers = 0;
        bool is_unlimited = false;
    };

    /// A result that is being verified.
    struct Arrived {
        Shard shard;
        Outcome outcome;
    };

    [[nodiscard]] bool has_work() const {
        return !waiting_.empty() || !under_way_.empty() || !arrived_.empty();
    }

    void step() {
        const auto begin = Clock::now();
        submit_what_is_wanted();
        result_.own_seconds += seconds_since(begin);
        auto outcome = engine_.wait(patience);
        const auto arrival = Clock::now();
        if (outcome) {
            take(std::move(*outcome));
        }
        while (auto answer = judges_ ? judges_->answer() : std::nullopt) {
            take(*answer);
        }
        look_at_workers();
        result_.own_seconds += seconds_since(arrival);
    }

    void submit_what_is_wanted() {
        // Results that wait for their verification count: faster workers would only fill the memory.
        while (!waiting_.empty() && under_way_.size() + arrived_.size() < engine_.wanted()) {
            Shard shard = std::move(waiting_.front());
            waiting_.pop_front();
            Task task{shard.part.id, folder_.order(shard.part).text(), {}, {}};
            for (const std::string& input : folder_.plan().inputs) {
                task.inputs.push_back(folder_.path() + "/" + input);
            }
            if (!shard.is_unlimited) {
                task.limit = options_.shard_limit;
            }
            engine_.submit(task);
            under_way_.emplace(shard.part.id, std::move(shard));
        }
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
        const bool is_open = judgement.verdict == Verdict::open;
        const bool stays_open = is_open && ++arrived.shard.open_answers >= most_open_answers;
        if (judgement.verdict == Verdict::proved || stays_open) {
            accept(arrived.shard, arrived.outcome);
            if (stays_open) {
                options_.note(fmt::format("shard {}: {}; to try it again, move '{}' elsewhere",
                                          arrived.shard.part.id, judgement.reason,
                                          folder_.result_file(arrived.shard.part.id)));
            }
            return;
        }
        ++result_.rejected;
        if (!is_open) {
            engine_.distrust(arrived.outcome);
        }
        folder_.reject(arrived.shard.part.id, arrived.outcome.result);
        log(What::rejected, arrived.shard.part.id, arrived.outcome.worker, arrived.outcome.seconds,
            judgement.reason);
        try_again(std::move(arrived.shard), judgement.reason);
    }

    void accept(const Shard& shard, const Outcome& outcome) {
        const bool is_new = folder_.keep_result(shard.part.id, outcome.result);
        log(is_new ? What::done : What::again, shard.part.id, outcome.worker, outcome.seconds, "");
        ++(is_new ? result_.accepted : result_.again);
        result_.worked += outcome.seconds;
        ++finished_;
        options_.progress(finished_, all_);
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
        options_.progress(finished_, all_);
    }

    void try_again(Shard shard, const std::string& reason) {
        if (++shard.attempts < most_attempts) {
            waiting_.push_back(std::move(shard));
            return;
        }
        ++result_.given_up;
        options_.note(fmt::format("shard {} is given up after {} attempts: {}", shard.part.id, most_attempts,
                                  printable(reason, 200)));
    }

    void look_at_workers() {
        const auto now = Clock::now();
        if (now - last_state_ >= between_states) {
            log_state();
        }
        if (engine_.figures().workers > 0) {
            last_company_ = now;
        } else {
            options_.lonely(seconds_since(last_company_));
        }
    }

    void log_state() {
        last_state_ = Clock::now();
        const EngineFigures f = engine_.figures();
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
    std::unique_ptr<Judges> judges_;
    std::deque<Shard> waiting_;
    std::map<std::string, Shard> under_way_;
    std::map<std::size_t, Arrived> arrived_;
    std::size_t next_number_ = 0;
    std::size_t all_ = 0;
    std::size_t finished_ = 0;
    CampaignRun result_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point last_state_ = start_;
    Clock::time_point last_company_ = start_;
};

}  // namespace

CampaignRun run_campaign(CampaignFolder& folder, Engine& engine, const CampaignOptions& options) {
    return Run(folder, engine, options).run();
}

}  // namespace dumbbell
