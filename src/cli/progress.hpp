#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

namespace dumbbell {

/// A progress line on stderr for work that takes longer than a second, if stderr is a terminal; silent
/// otherwise.
class Progress {
  public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Thread-safe.
    void update(std::size_t done, std::size_t total);

  private:
    using Clock = std::chrono::steady_clock;

    std::mutex mutex_;
    const bool terminal_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool shown_ = false;
};

}  // namespace dumbbell
