// Trees for tests.
#pragma once

#include <random>

#include "rooms/collisions/example.hpp"

namespace dumbbell_test {

using namespace dumbbell;
using namespace dumbbell::collisions;

inline Node leaf() { return {std::nullopt, {Reason::outside}}; }

/// Appends a random complete tree of `leaves` leaves that splits the given axes.
inline void grow(Tree& tree, long leaves, const std::vector<Axis>& axes, std::mt19937& random) {
    if (leaves == 1) {
        tree.push_back(leaf());
        return;
    }
    tree.push_back(split(axes[random() % axes.size()]));
    const long lower = std::uniform_int_distribution<long>(1, leaves - 1)(random);
    grow(tree, lower, axes, random);
    grow(tree, leaves - lower, axes, random);
}

inline Tree random_tree(long leaves, const std::vector<Axis>& axes, unsigned seed) {
    std::mt19937 random(seed);
    Tree tree;
    grow(tree, leaves, axes, random);
    return tree;
}

inline const std::vector<Axis> three_axes{Axis::position, Axis::slope, Axis::ratio};
inline const std::vector<Axis> plane_axes{Axis::position, Axis::slope};

}  // namespace dumbbell_test
