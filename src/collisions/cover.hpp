#pragma once

#include <cstddef>
#include <optional>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/leaf.hpp"
#include "collisions/section.hpp"

namespace dumbbell::collisions {

/// The order in which axes are split. `by_bounds` takes the one that the bounds of an open box depend on, or
/// else compares position with slope / r, the natural units of the counts; the others exist to show that
/// nothing but the number of leaves depends on it.
enum class SplitRule { by_bounds, slope_first, position_first };

struct CoverOptions {
    SplitRule rule = SplitRule::by_bounds;
    std::size_t max_nodes = 20000;  ///< give up beyond
    int max_depth = 400;            ///< per axis; the format's limit
    bool parallel = false;          ///< judge the boxes of a generation on all of the calling arena's threads
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
};

/// A bisection tree of the chart over mass ratios [q_lo, q_hi], each leaf of which closes for "at most
/// `upper` collisions"; nothing if none was found within the options' limits. Deterministic, whatever the
/// number of threads.
template <class I>
[[nodiscard]] std::optional<Tree> cover(Chart chart, const Rational& q_lo, const Rational& q_hi,
                                        const Count& upper, const CoverOptions& options);

}  // namespace dumbbell::collisions
