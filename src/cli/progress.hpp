#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace dumbbell {

enum class Loudness { normal, quiet };

/// A progress line on stderr for work that takes longer than a second, if stderr is a terminal and the user
/// did not ask for quiet; silent otherwise, but for notes. It is never wider than the terminal.
class Progress {
  public:
    /// `unit`: what is counted, in the plural.
    explicit Progress(std::string_view unit = "pieces", Loudness loudness = Loudness::normal);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `count`: the number of collisions N that the work is at, if there is one. Thread-safe.
    void update(std::size_t done, std::size_t total, std::optional<long> count = std::nullopt);

    /// The same for work of unknown size: `more` was done since the last call.
    void advance(std::size_t more);

    /// A message on stderr, a line of its own. Thread-safe.
    void note(const std::string& line);

  private:
    using Clock = std::chrono::steady_clock;

    void clear();
    /// Whether a line is due, which then is shown.
    [[nodiscard]] bool is_due();
    /// Seconds from the start to this line.
    [[nodiscard]] double elapsed() const;

    const std::string_view unit_;
    std::mutex mutex_;
    const bool shows_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool shown_ = false;
    std::size_t done_ = 0;
};

}  // namespace dumbbell
