// For people who wait: how far the verifier is.
#pragma once
#include <condition_variable>
#include <mutex>
#include <string>

#include "verify/machine/threads.hpp"

namespace dumbbell_verify {

/// One line on stderr that is written over and over, without escape codes, from the second second on; nothing
/// unless it is wanted and stderr is a terminal.
class Progress {
  public:
    /// `budget`: of each file, in units of work.
    Progress(bool wanted, std::uint64_t budget);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The line is gone, and does not come again before the lock is.
    [[nodiscard]] std::unique_lock<std::mutex> hidden();

  private:
    void show(const std::string& text);
    void watch();

    const std::uint64_t budget_;
    std::mutex mutex_;
    std::condition_variable ends_;
    bool ended_ = false;
    std::string shown_;  ///< the line
    Crew crew_;          ///< last: it uses the rest
};

}  // namespace dumbbell_verify
