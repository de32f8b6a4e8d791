#pragma once

#include "model/ray.hpp"

namespace dumbbell::batch {

/// A question about the lowest, flattest ray of a set: c >= 0, kappa >= -r, 0 < r <= 1, and up to which
/// number its collisions are of interest (below 2^53).
struct Query {
    Ray<double> ray;
    long cap = 0;
};

struct Answer {
    long most =
        0;  ///< G <= this for all rays at or above the query's in c, kappa and r; cap + 1: not certain
    /// Nothing on the way was decided narrowly: what is not certain here would not be so with closer bounds.
    bool clear = false;
};

/// Asked now and then whether to end early; what has no answer by then is not certain.
struct Stop {
    bool (*asks)(const void* context) = nullptr;
    const void* context = nullptr;
};

}  // namespace dumbbell::batch
