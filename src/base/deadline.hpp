#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "base/interrupted.hpp"

namespace dumbbell {

/// The signal that asked the program to stop, 0: none. Work that is under way ends early, as if its budget
/// were used up.
inline std::atomic<int> stop_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");

/// What may also end work early that begins on this thread: the caller of a library (src/wings/api); null:
/// nobody.
inline thread_local const Interrupted* caller_stops = nullptr;

/// Whether a budget that begins now is used up, or the program was asked to stop.
[[nodiscard]] inline Interrupted deadline(const std::optional<std::chrono::duration<double>>& budget) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::duration<double> practically_for_ever(1e9);  // and no overflow of the clock
    const Interrupted caller = caller_stops == nullptr ? never : *caller_stops;
    if (!budget || *budget > practically_for_ever) {
        return [caller] { return stop_signal != 0 || caller(); };
    }
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(*budget);
    return [end, caller] { return stop_signal != 0 || Clock::now() >= end || caller(); };
}

}  // namespace dumbbell
