#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace dumbbell {

/// A progress line on stderr for work that takes longer than a second, if stderr is a terminal; silent
/// otherwise, but for notes.
class Progress {
  public:
    /// `unit`: what is counted, in the plural.
    explicit Progress(std::string_view unit = "pieces");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Thread-safe.
    void update(std::size_t done, std::size_t total);

    /// The same for work of unknown size: `more` was done since the last call.
    void advance(std::size_t more);

    /// A message on stderr, a line of its own. Thread-safe.
    void note(const std::string& line);

  private:
    using Clock = std::chrono::steady_clock;

    void clear();
    /// Whether a line is due, which then is shown.
    [[nodiscard]] bool is_due();

    const std::string_view unit_;
    std::mutex mutex_;
    const bool terminal_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool shown_ = false;
    std::size_t done_ = 0;
};

}  // namespace dumbbell
