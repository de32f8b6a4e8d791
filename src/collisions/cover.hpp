#pragma once

#include <cstddef>
#include <optional>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/leaf.hpp"

namespace dumbbell::collisions {

struct CoverOptions {
    std::size_t max_nodes = 20000;  ///< give up beyond
    int max_depth = 400;            ///< per axis; the format's limit
    bool parallel = false;          ///< judge the boxes of a generation on all of the calling arena's threads
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
    System system = {};
};

/// A bisection tree of the chart over mass ratios [q_lo, q_hi], each leaf of which closes for "at most
/// `upper` collisions"; nothing if none was found within the options' limits. An open box is split in the
/// axis that its bounds depend on, or else in the longest, in the natural units of the counts. Deterministic,
/// whatever the number of threads.
template <class I>
[[nodiscard]] std::optional<Tree> cover(Chart chart, const Rational& q_lo, const Rational& q_hi,
                                        const Count& upper, const CoverOptions& options);

}  // namespace dumbbell::collisions
