#include "number/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "number/big_interval.hpp"
#include "number/flint.hpp"
#include "number/self_test.hpp"
#include "number/sound_arithmetic.hpp"

namespace dumbbell {
namespace {

struct Loop {
    std::size_t count;
    std::size_t together;
    const std::function<void(std::size_t, std::size_t)>& work;
    int bits;
    std::size_t next = 0;       ///< of [0, count): what has not been begun
    std::size_t under_way = 0;  ///< parts
    std::exception_ptr failure = nullptr;
};

/// The threads of one run_with_threads, and its loops. Made and ended on the thread that runs it.
class Crew {
  public:
    explicit Crew(int jobs);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    void run(Loop& loop);

    inline static thread_local Crew* present = nullptr;  ///< this thread's

  private:
    void help();
    void do_part(Loop& loop, std::unique_lock<std::mutex>& lock);

    const std::size_t jobs_;
    Crew* const before_;  ///< of the thread that has made it
    std::mutex mutex_;
    std::condition_variable more_, done_;
    std::vector<Loop*> loops_;  ///< that have parts to begin; the innermost are the last
    bool ends_ = false;
    std::vector<std::thread> helpers_;
};

Crew::Crew(int jobs) : jobs_(static_cast<std::size_t>(jobs)), before_(std::exchange(present, this)) {
    try {
        for (int i = 1; i < jobs; ++i) {
            helpers_.emplace_back([this] { help(); });
        }
    } catch (const std::exception&) {  // no more may start: those that did do the work
    }
}

Crew::~Crew() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    more_.notify_all();
    for (std::thread& helper : helpers_) {
        helper.join();
    }
    present = before_;
}

void Crew::help() {
    const DefaultEnvironment environment;
    present = this;
    std::unique_lock lock(mutex_);
    for (;;) {
        more_.wait(lock, [&] { return ends_ || !loops_.empty(); });
        if (ends_) {
            break;
        }
        do_part(*loops_.back(), lock);
    }
    flint_cleanup();  // what it and MPFR keep for this thread
}

void Crew::do_part(Loop& loop, std::unique_lock<std::mutex>& lock) {
    const std::size_t begin = loop.next;
    const std::size_t share = (loop.count - begin) / (16 * jobs_);
    loop.next += std::min(loop.count - begin, std::max(loop.together, share));
    const std::size_t end = loop.next;
    if (end == loop.count) {
        std::erase(loops_, &loop);
    }
    ++loop.under_way;
    lock.unlock();
    std::exception_ptr failure;
    try {
        require_sound_arithmetic();
        const PrecisionScope scope(loop.bits);
        loop.work(begin, end);
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (failure) {
        loop.failure = loop.failure ? loop.failure : failure;
        loop.next = loop.count;
        std::erase(loops_, &loop);
    }
    if (--loop.under_way == 0) {
        done_.notify_all();
    }
}

void Crew::run(Loop& loop) {
    std::unique_lock lock(mutex_);
    loops_.push_back(&loop);
    more_.notify_all();
    while (loop.next < loop.count) {
        do_part(loop, lock);
    }
    done_.wait(lock, [&] { return loop.under_way == 0; });
    if (loop.failure) {
        std::rethrow_exception(loop.failure);
    }
}

}  // namespace

void in_parallel(std::size_t count, std::size_t together,
                 const std::function<void(std::size_t begin, std::size_t end)>& work) {
    if (count == 0) {
        return;
    }
    if (Crew::present == nullptr || count <= together) {
        return work(0, count);
    }
    Loop loop{count, together, work, PrecisionScope::current()};
    Crew::present->run(loop);
}

void run_with_threads(int jobs, const std::function<void()>& work) {
    Crew crew(jobs);
    work();
}

}  // namespace dumbbell
