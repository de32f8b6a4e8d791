#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

/// Work on several threads, all of whose arithmetic is sound. TBB's headers take long to compile: they are in
/// the source file alone.
namespace dumbbell {

/// work(begin, end) for parts of [0, count) that are all of it together, in any order, on the threads of
/// `with_threads` or all cores. A part of more than `together` may be halved. Throws what `work` throws, and
/// BrokenInvariant on a thread whose arithmetic is unsound (require_sound_arithmetic). Each part has the
/// caller's precision. A thread that waits for it begins nothing else meanwhile.
void in_parallel(std::size_t count, std::size_t together,
                 const std::function<void(std::size_t begin, std::size_t end)>& work);

/// The same with work(i) for each i < count.
template <class Work>
void in_parallel(std::size_t count, const Work& work) {
    in_parallel(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
            work(i);
        }
    });
}

/// Whether this is all that the program does now: then there are as many threads as jobs, also more than
/// cores.
enum class Threads { shared, all };

void run_with_threads(int jobs, Threads threads, const std::function<void()>& work);

/// What `work` returns, whose parallel work is done on at most so many threads.
template <class Work>
[[nodiscard]] auto with_threads(int jobs, Threads threads, const Work& work) {
    std::optional<std::invoke_result_t<const Work&>> result;
    run_with_threads(jobs, threads, [&] { result = work(); });
    return std::move(*result);
}

}  // namespace dumbbell
