#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

/// Work on several threads, all of whose arithmetic is sound.
namespace dumbbell {

/// work(begin, end) for parts of [0, count) that are all of it together, in any order, on the threads of
/// `run_with_threads`, outside of it on this one alone. Parts have `together` or more. Throws what the first
/// part to fail throws; then parts are left out. Each part has the caller's precision. A thread that waits
/// for the others begins nothing else meanwhile.
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

/// work(), whose parallel work, loops in loops too, is done on so many threads, this one among them; on fewer
/// where no more may start.
void run_with_threads(int jobs, const std::function<void()>& work);

/// The same; returns what `work` returns.
template <class Work>
[[nodiscard]] auto with_threads(int jobs, const Work& work) {
    std::optional<std::invoke_result_t<const Work&>> result;
    run_with_threads(jobs, [&] { result = work(); });
    return std::move(*result);
}

}  // namespace dumbbell
