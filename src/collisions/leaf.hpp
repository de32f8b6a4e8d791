#pragma once

#include <optional>
#include <span>

#include "base/interrupted.hpp"
#include "collisions/section.hpp"

namespace dumbbell::collisions {

/// Bounds each box: result[i] is the reason that closes boxes[i] for "no trajectory has more than `upper`
/// collisions", or nothing where none is certain, or where it was interrupted. I: Interval or BigInterval
/// (with the calling thread's precision).
template <class I>
void judge(Chart chart, std::span<const Box> boxes, const Count& upper,
           std::span<std::optional<Leaf>> results, const Interrupted& interrupted = never);

}  // namespace dumbbell::collisions
