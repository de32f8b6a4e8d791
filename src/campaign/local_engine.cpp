#include "campaign/local_engine.hpp"

#include <exception>
#include <utility>

#include "base/deadline.hpp"
#include "campaign/kind.hpp"
#include "number/self_test.hpp"

namespace dumbbell::campaign {

LocalEngine::LocalEngine(int jobs, std::string folder)
    : jobs_(jobs),
      folder_(std::move(folder)),
      limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs) + 1),
      arena_(jobs, 0) {}

LocalEngine::~LocalEngine() {
    closing_ = true;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return under_way_ == 0; });
}

Outcome LocalEngine::carry_out(const Task& task) const {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Outcome outcome{
        .id = task.id, .end = Outcome::End::too_long, .result = {}, .reason = {}, .worker = "local"};
    try {
        require_sound_arithmetic();
        const Order order = parse_order(task.order);
        const Interrupted late = deadline(task.limit);
        const auto result = kind_named(order.kind()).work(order, folder_, [&] { return closing_ || late(); });
        if (result) {
            outcome.end = Outcome::End::done;
            outcome.result = *result;
        }
    } catch (const std::exception& error) {
        outcome.end = Outcome::End::failed;
        outcome.reason = error.what();
    }
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return outcome;
}

Task LocalEngine::next_task() {
    const std::lock_guard lock(mutex_);
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    return task;
}

void LocalEngine::submit(const Task& task) {
    {
        const std::lock_guard lock(mutex_);
        ++under_way_;
        waiting_.push_back(task);
    }
    // Not the task itself: the arena may keep what it is given until after the engine is gone.
    arena_.enqueue([this] {
        ++running_;
        Outcome outcome = carry_out(next_task());
        --running_;
        const std::lock_guard lock(mutex_);
        // A shard that was given up because the program is to stop says nothing of its size.
        if (stop_signal == 0 || outcome.end == Outcome::End::done) {
            outcomes_.push_back(std::move(outcome));
        }
        --under_way_;
        changed_.notify_all();
    });
}

std::optional<Outcome> LocalEngine::wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [&] { return !outcomes_.empty(); });
    if (outcomes_.empty()) {
        return std::nullopt;
    }
    Outcome outcome = std::move(outcomes_.front());
    outcomes_.pop_front();
    return outcome;
}

EngineFigures LocalEngine::figures() const {
    EngineFigures figures;
    figures.workers = figures.joined = static_cast<std::size_t>(jobs_);
    figures.running = running_;
    return figures;
}

}  // namespace dumbbell::campaign
