#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace dumbbell {

/// Whether a budget that begins now is used up; never without one.
[[nodiscard]] inline std::function<bool()> deadline(
    const std::optional<std::chrono::duration<double>>& budget) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::duration<double> practically_for_ever(1e9);  // and no overflow of the clock
    if (!budget || *budget > practically_for_ever) {
        return [] { return false; };
    }
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(*budget);
    return [end] { return Clock::now() >= end; };
}

}  // namespace dumbbell
