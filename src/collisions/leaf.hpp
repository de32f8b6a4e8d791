#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "collisions/chart.hpp"

namespace dumbbell::collisions {

/// The reason that closes the box for "no trajectory has more than `upper` collisions"; nothing where none is
/// certain, or where it was interrupted. I: Interval or BigInterval (with the calling thread's precision).
template <class I>
[[nodiscard]] std::optional<Leaf> judge(Chart chart, const Box& box, const Count& upper,
                                        const Interrupted& interrupted = never);

}  // namespace dumbbell::collisions
