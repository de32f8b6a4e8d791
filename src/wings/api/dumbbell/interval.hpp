#pragma once

#include "dumbbell/abi.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// All real numbers from lo to hi, both included. A result contains what it encloses: its ends are rounded
/// outward.
struct Interval {
    double lo = 0;
    double hi = 0;
};

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
