#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "base/observer.hpp"

namespace dumbbell::cli {

enum class Verbosity { normal, quiet };

/// A progress line on stderr for work that takes longer than a second, if stderr is a terminal and the user
/// did not ask for quiet; silent otherwise, but for notes. It is never wider than the terminal. It names the
/// phase that the work is in, if it has one, and while there is nothing to count says for how long.
class Progress : public Observer {
  public:
    /// `unit`: what is counted, in the plural. `phase`: what is done at first, for example `proving`.
    explicit Progress(std::string_view unit = "pieces", Verbosity verbosity = Verbosity::normal,
                      std::string_view phase = "");
    ~Progress() override;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Where parts do not take equally long: the share of the time that the first so many take.
    void weigh(std::function<double(std::size_t)> share) { share_ = std::move(share); }

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
    /// Whether a line is due, which then is shown.
    [[nodiscard]] bool is_due();
    /// Seconds from the phase's start to this line.
    [[nodiscard]] double elapsed() const;
    /// Says how long the phase takes while nothing is counted in it.
    void tick();

    std::string_view unit_;
    std::string_view phase_;
    std::function<double(std::size_t)> share_;
    std::mutex mutex_;
    const bool shows_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point phase_start_ = start_;
    Clock::time_point last_ = start_;
    bool shown_ = false;
    bool counted_ = false;
    std::size_t done_ = 0;
    bool ends_ = false;
    std::condition_variable end_;
    std::thread ticker_;
};

}  // namespace dumbbell::cli
