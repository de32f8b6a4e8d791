#include "file/in_order.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "number/parallel.hpp"

namespace dumbbell {
namespace {

class Stream {
  public:
    using Next = std::function<Work(const Interrupted& in_vain)>;

    Stream(const Next& next, std::size_t most) : next_(next), most_(most) {}

    /// One thread's part.
    void help();

  private:
    struct Taken {
        std::size_t number;
        Work work;
    };

    /// Nothing at the end.
    std::optional<Taken> take();
    void put(std::size_t number, HandOn result);
    void end();

    const Next& next_;
    const std::size_t most_;
    std::mutex
        taking_;  ///< held while `next_` waits: taken before the other one, which is never held so long
    std::mutex handing_;
    std::condition_variable room_;
    std::deque<std::optional<HandOn>> results_;  ///< of what is begun; the first is handed on next
    std::size_t handed_ = 0;
    std::atomic<bool> ended_ = false;  ///< no more is wanted; set with `handing_`
};

void Stream::help() {
    try {
        while (auto taken = take()) {
            put(taken->number, taken->work());
        }
    } catch (...) {
        end();  // else the others would wait for this thread's result
        throw;
    }
}

std::optional<Stream::Taken> Stream::take() {
    const std::scoped_lock one(taking_);
    {
        std::unique_lock lock(handing_);
        room_.wait(lock, [&] { return ended_ || results_.size() < most_; });
        if (ended_) {
            return std::nullopt;
        }
    }
    Work work = next_([this] { return ended_.load(); });
    if (!work) {
        return std::nullopt;  // what is begun is still handed on
    }
    const std::scoped_lock lock(handing_);
    results_.emplace_back();
    return Taken{handed_ + results_.size() - 1, std::move(work)};
}

void Stream::put(std::size_t number, HandOn result) {
    const std::scoped_lock lock(handing_);
    results_[number - handed_] = std::move(result);
    while (!ended_ && !results_.empty() && results_.front()) {
        ended_ = !(*results_.front())();
        results_.pop_front();
        ++handed_;
    }
    room_.notify_all();
}

void Stream::end() {
    const std::scoped_lock lock(handing_);
    ended_ = true;
    room_.notify_all();
}

}  // namespace

void in_order(int jobs, const std::function<Work(const Interrupted& in_vain)>& next) {
    const auto threads = static_cast<std::size_t>(jobs);
    Stream stream(next, pieces_ahead * threads);
    run_with_threads(jobs, [&] { in_parallel(threads, [&](std::size_t) { stream.help(); }); });
}

}  // namespace dumbbell
