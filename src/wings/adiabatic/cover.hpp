#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "adiabatic/box.hpp"
#include "base/interrupted.hpp"
#include "base/observer.hpp"

/// Covers of a box by boxes on each of which a bound holds: the trees of an adiabatic certificate.
namespace dumbbell::adiabatic {

/// What is certain of a box: nothing in it satisfies the hypotheses, or a bound of the error on it.
struct Judged {
    bool outside = false;
    double bound = std::numeric_limits<double>::infinity();
    int by_class = 0;
};
/// Called from any thread.
using Judge = std::function<Judged(const Box&)>;

struct Limits {
    int jobs = 1;
    std::size_t max_leaves = 100'000;
    int max_depth = 40;  ///< splits of one axis
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
};

/// The bound that is good enough: `goal`, or `slack` (relative) more than the greatest that the judge gives
/// at the centres of boxes; and if neither can be met, the least that the halving reaches. With `fixed` the
/// goal itself.
struct Target {
    double goal = 0;
    double slack = 0;
    bool fixed = false;
};

struct Cover {
    Tree tree;
    double bound = 0;  ///< the greatest of its leaves
    std::size_t leaves = 0;
};

/// Halves `root` until each box is outside or within the target, always along the axis whose halving seems to
/// help most. Nothing if interrupted, or where no bound is found within the limits, or none can be because
/// there is none at the centre of some box. Deterministic whatever the number of threads.
[[nodiscard]] std::optional<Cover> find_cover(const Box& root, const Judge& judge, const Target& target,
                                              const Limits& limits);

}  // namespace dumbbell::adiabatic
