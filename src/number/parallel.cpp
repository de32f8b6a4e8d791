#include "number/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "number/big_interval.hpp"
#include "number/self_test.hpp"

namespace dumbbell {

void in_parallel(std::size_t count, std::size_t together,
                 const std::function<void(std::size_t begin, std::size_t end)>& work) {
    const int bits = PrecisionScope::current();
    // Its own: or what another part of a loop around this one throws would end this one silently, half done.
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, together),
            [&](const auto& range) {
                require_sound_arithmetic();
                const PrecisionScope scope(bits);
                work(range.begin(), range.end());
            },
            context);
    });
}

void run_with_threads(int jobs, Threads threads, const std::function<void()>& work) {
    std::optional<tbb::global_control> limit;
    if (threads == Threads::all) {
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
    }
    tbb::task_arena(jobs).execute(work);
}

}  // namespace dumbbell
