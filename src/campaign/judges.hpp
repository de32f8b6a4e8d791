#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "campaign/kind.hpp"

namespace dumbbell::campaign {

/// Results to be looked at, each by one of several threads.
class Judges {
  public:
    struct Case {
        Order order;
        std::string file;
        std::size_t number = 0;  ///< for the caller
    };
    struct Answer {
        std::size_t number = 0;
        Judgement judgement;
        double seconds = 0;
    };

    /// `folder`: where the plan's inputs lie. Throws InputError if this number of threads cannot be started.
    Judges(const Kind& kind, std::string folder, int jobs, Scrutiny scrutiny);
    /// What nobody looked at yet is forgotten.
    ~Judges();
    Judges(const Judges&) = delete;
    Judges& operator=(const Judges&) = delete;

    void ask(Case question);
    /// The next answer, in no particular order; nothing if there is none yet. Throws what a judge met.
    [[nodiscard]] std::optional<Answer> answer();
    /// The same, but waits for it. Precondition: something was asked that has no answer yet.
    [[nodiscard]] Answer next_answer();

  private:
    void work();
    void stop();
    [[nodiscard]] Answer taken();

    const Kind& kind_;
    std::string folder_;
    Scrutiny scrutiny_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Case> questions_;
    std::deque<Answer> answers_;
    std::exception_ptr failure_;
    bool ends_ = false;
    std::vector<std::jthread> crew_;
};

}  // namespace dumbbell::campaign
