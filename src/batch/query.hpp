#pragma once

#include "model/ray.hpp"

namespace dumbbell::batch {

/// A ray, c >= 0, kappa >= -r, 0 < r <= 1, and up to which number its collisions are of interest (0 or more,
/// below 2^53).
struct Query {
    Ray<double> ray;
    long cap = 0;
};

struct Answer {
    long count = 0;
    /// Nothing on the way was decided narrowly: what is not certain here would not be so with closer bounds.
    bool clear = false;
};

/// Asked now and then whether to end early.
struct Stop {
    bool (*asks)(const void* context) = nullptr;
    const void* context = nullptr;
};

}  // namespace dumbbell::batch
