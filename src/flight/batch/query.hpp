#pragma once

#include "flight/ray.hpp"

namespace dumbbell::flight::batch {

/// The kernel counts in doubles.
inline constexpr long greatest_cap = 1L << 52;

/// A ray, c >= 0, kappa >= -r, 0 < r <= 1, and up to which number its collisions are of interest, 0 to
/// greatest_cap.
struct Query {
    Ray<double> ray;
    long cap = 0;
};

/// Rays with more collisions are followed faster one by one, by macro steps (flight/macro).
inline constexpr long most_worth_a_batch = 500'000;

struct Answer {
    long count = 0;
    /// Nothing on the way was decided by less than a thousandth.
    bool clear = false;
};

/// Up to this number of collisions, bounds that are off by 1e-14 at each, which grows with the square of
/// their number, stay far closer than what is called clear.
inline constexpr long most_clear_collisions = 4096;

/// Whether closer bounds would give the same count. Only to save work: nothing is proved by it.
[[nodiscard]] inline bool settled(const Answer& answer) {
    return answer.clear && answer.count <= most_clear_collisions;
}

/// Asked now and then whether to end early.
struct Stop {
    bool (*asks)(const void* context) = nullptr;
    const void* context = nullptr;
};

}  // namespace dumbbell::flight::batch
