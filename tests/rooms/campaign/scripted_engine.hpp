// An engine that answers as a test says, at once and in an order of its own, and a campaign for it.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "campaign/engine.hpp"
#include "campaign/folder.hpp"
#include "campaign/kind.hpp"
#include "campaign/kinds/kinds.hpp"

namespace dumbbell_test {

/// What becomes of a task; `attempt` counts from 1.
using Script = std::function<dumbbell::campaign::Outcome(const dumbbell::campaign::Task&, int attempt)>;

class ScriptedEngine : public dumbbell::campaign::Engine {
  public:
    explicit ScriptedEngine(Script script, std::size_t wanted = 8)
        : script_(std::move(script)), wanted_(wanted) {}

    void submit(const dumbbell::campaign::Task& task) override {
        const auto at = static_cast<std::ptrdiff_t>(random_() % (tasks_.size() + 1));
        tasks_.insert(tasks_.begin() + at, task);
        most_ = std::max(most_, tasks_.size());
    }
    std::optional<dumbbell::campaign::Outcome> wait(std::chrono::milliseconds /*time*/) override {
        if (tasks_.empty()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return std::nullopt;
        }
        const dumbbell::campaign::Task task = std::move(tasks_.front());
        tasks_.pop_front();
        return script_(task, ++attempts_[task.id]);
    }
    void distrust(const dumbbell::campaign::Outcome& outcome) override {
        distrusted_.push_back(outcome.worker);
    }
    [[nodiscard]] std::size_t wanted() const override { return wanted_; }
    [[nodiscard]] dumbbell::campaign::EngineFigures figures() const override {
        dumbbell::campaign::EngineFigures figures;
        figures.workers = 1;
        figures.running = tasks_.size();
        return figures;
    }

    /// The number of tasks that were under way at the same time.
    [[nodiscard]] std::size_t most() const { return most_; }
    /// Whose results were rejected.
    [[nodiscard]] const std::vector<std::string>& distrusted() const { return distrusted_; }
    /// How often each task was tried.
    [[nodiscard]] const std::map<std::string, int>& attempts() const { return attempts_; }

  private:
    Script script_;
    std::size_t wanted_;
    std::deque<dumbbell::campaign::Task> tasks_;
    std::map<std::string, int> attempts_;
    std::vector<std::string> distrusted_;
    std::mt19937 random_{7};
    std::size_t most_ = 0;
};

inline dumbbell::campaign::Outcome done(const dumbbell::campaign::Task& task, std::string result) {
    return {task.id, dumbbell::campaign::Outcome::End::done, std::move(result), {}, "far", 0.5};
}
inline dumbbell::campaign::Outcome failed(const dumbbell::campaign::Task& task, std::string reason) {
    return {task.id, dumbbell::campaign::Outcome::End::failed, {}, std::move(reason), "far", 0.5};
}
inline dumbbell::campaign::Outcome too_long(const dumbbell::campaign::Task& task) {
    return {task.id, dumbbell::campaign::Outcome::End::too_long, {}, {}, "far", 0.5};
}

/// The true result of a task.
inline dumbbell::campaign::Outcome worked(const dumbbell::campaign::Task& task) {
    const dumbbell::campaign::Order order = dumbbell::campaign::parse_order(task.order);
    return done(task, *dumbbell::campaign::kind_named(order.kind()).work(order, ".", dumbbell::never));
}

/// A small campaign: critical ratios, which are enclosed in milliseconds.
inline dumbbell::campaign::Plan small_plan(long first = 3, long last = 14, std::size_t shards = 4) {
    dumbbell::staircase::CriticalRequest request;
    request.first = first;
    request.last = last;
    request.digits = 10;
    return dumbbell::campaign::plan_critical(request, shards);
}

}  // namespace dumbbell_test
