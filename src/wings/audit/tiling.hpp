#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "collisions/leaf_boxes.hpp"

namespace dumbbell::audit {

/// Why boxes do not tile their root.
enum class Fault {
    reversed,      ///< box `first` has an end before its beginning
    sticks_out,    ///< box `first` reaches beyond the root
    overlap,       ///< the interiors of `first` and `second` meet
    missing_area,  ///< part of the root is in no box
};

/// What was found about boxes in a root. Without a fault they tile it: each lies in the root, their interiors
/// are pairwise disjoint and their volumes add up to the root's, all exactly; what is left of the root is an
/// open set of volume 0, i.e. empty. Axes on which the root is a single number do not count.
struct Tiling {
    std::size_t leaves = 0;
    std::size_t pairs = 0;  ///< pairs that the box filter could not separate, each compared exactly
    Rational missing = 0;   ///< with Fault::missing_area: the part of the root's area that is in no box
    Rational area = 0;      ///< the root's, over its axes of positive width
    std::optional<Fault> fault{};
    std::size_t first = 0;   ///< index of a box
    std::size_t second = 0;  ///< index of a box
};

/// Called with the part of the work that is done, from 0 to 1, now and then.
using TilingProgress = std::function<void(double done)>;

/// Throws InputError in a build without CGAL, which can check no tiling.
void need_exact_geometry();

/// Whether the boxes tile their root, in exact arithmetic (CGAL). Looks at the boxes only, not at a tree.
/// Stops at the first fault.
[[nodiscard]] Tiling check_tiling(
    const collisions::Boxes& boxes, const TilingProgress& progress = [](double /*done*/) {});

}  // namespace dumbbell::audit
