#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "base/observer.hpp"

namespace dumbbell::cli {

enum class Verbosity { normal, quiet };

/// A progress line on stderr for work that takes longer than a second, if stderr is a terminal and the user
/// did not ask for quiet; silent otherwise, but for notes. It is never wider than the terminal. It names the
/// phase that the work is in, and while there is nothing to count says for how long. It goes on by time, also
/// while one part takes long.
class Progress : public Observer {
  public:
    /// `unit`: what is counted, in the plural. `phase`: what is done at first, for example `proving`.
    Progress(std::string_view unit, Verbosity verbosity, std::string_view phase);
    ~Progress() override;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Another phase begins, unless the work is in it. Thread-safe.
    void enter(std::string_view phase, std::string_view unit) override;

    /// `count`: the number of collisions N that the work is at, if there is one. Thread-safe.
    void update(std::size_t done, std::size_t total, std::optional<long> count) override;

    /// The same for work of unknown size: `more` was done since the last call.
    void advance(std::size_t more) override;

    /// A message on stderr, a line of its own. Thread-safe.
    void note(const std::string& line) override;

  private:
    using Clock = std::chrono::steady_clock;

    void clear();
    /// Shows the line, unless the work is young or the one before it is.
    void show_if_due();
    /// How far the work is; no longer than this, if that is possible.
    [[nodiscard]] std::string line(std::size_t room) const;
    /// Seconds from the phase's start to this line.
    [[nodiscard]] double elapsed() const;
    /// Shows the line while nobody tells of anything.
    void tick();

    std::string_view unit_;
    std::string_view phase_;
    std::mutex mutex_;
    const bool shows_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point phase_start_ = start_;
    Clock::time_point last_ = start_;
    bool shown_ = false;
    std::size_t done_ = 0;
    std::size_t total_ = 0;  ///< 0: not known
    std::optional<long> count_;
    bool ends_ = false;
    std::condition_variable end_;
    std::thread ticker_;
};

}  // namespace dumbbell::cli
