#pragma once

#include <cstddef>
#include <vector>

#include "words/json.hpp"

/// A bisection tree as the page draws it.
namespace dumbbell::page {

/// Pre-order, lower half first: the number k >= 0 is a leaf of kind k, -1 - a a split of axis a.
using PictureTree = std::vector<int>;

[[nodiscard]] constexpr int split_of(std::size_t axis) { return -1 - static_cast<int>(axis); }

/// A tree that may have been thinned out: where a subtree was left away, a leaf stands for all of its leaves,
/// with the greatest of their kinds.
struct ThinnedTree {
    PictureTree nodes;
    std::vector<std::size_t> stands_for;  ///< for each leaf the number of leaves; empty if always 1
};

/// At most `most` leaves, at least 1: subtrees with many leaves and large boxes are shown in detail first.
/// Precondition: the tree is complete.
[[nodiscard]] ThinnedTree thinned(const PictureTree& tree, std::size_t most);

/// One more than it has splits. Precondition: the tree is complete.
[[nodiscard]] inline std::size_t leaves_of(const PictureTree& tree) { return tree.size() / 2 + 1; }

/// Of `total` leaves in all trees, `most` may be drawn.
struct BoxBudget {
    std::size_t total = 0;
    std::size_t most = 0;
};

/// How many leaves of a tree that has so many are drawn.
[[nodiscard]] std::size_t share_of(std::size_t leaves, const BoxBudget& budget);

/// {nodes, leaves, stands_for}
[[nodiscard]] Json tree_json(const PictureTree& tree, const BoxBudget& budget);

}  // namespace dumbbell::page
