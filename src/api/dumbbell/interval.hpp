#pragma once

namespace dumbbell::api {

/// All real numbers from lo to hi, both included. A result contains what it encloses: its ends are rounded
/// outward.
struct Interval {
    double lo = 0;
    double hi = 0;
};

}  // namespace dumbbell::api
