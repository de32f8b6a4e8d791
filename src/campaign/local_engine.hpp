#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>

#include "campaign/engine.hpp"

namespace dumbbell::campaign {

/// Processes shards on the threads of this program. `folder`: where the inputs of the orders lie.
class LocalEngine : public Engine {
  public:
    LocalEngine(int jobs, std::string folder);
    /// What is under way is given up.
    ~LocalEngine() override;
    LocalEngine(const LocalEngine&) = delete;
    LocalEngine& operator=(const LocalEngine&) = delete;

    void submit(const Task& task) override;
    [[nodiscard]] std::optional<Outcome> wait(std::chrono::milliseconds time) override;
    void distrust(const Outcome& /*outcome*/) override {}
    [[nodiscard]] std::size_t wanted() const override { return 2 * static_cast<std::size_t>(jobs_); }
    [[nodiscard]] EngineFigures figures() const override;

  private:
    [[nodiscard]] Outcome carry_out(const Task& task) const;
    [[nodiscard]] Task next_task();

    int jobs_;
    std::string folder_;
    tbb::global_control limit_;  ///< the thread that waits does not work
    tbb::task_arena arena_;
    std::atomic<bool> closing_ = false;
    std::atomic<std::size_t> running_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t under_way_ = 0;
    std::deque<Task> waiting_;
    std::deque<Outcome> outcomes_;
};

}  // namespace dumbbell::campaign
