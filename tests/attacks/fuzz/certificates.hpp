// Certificates of the program's own types, built from the decisions of an input.
#pragma once

#include "choices.hpp"
#include "collisions/certificate.hpp"

namespace dumbbell_fuzz {

/// 2^k.
[[nodiscard]] inline dumbbell::Rational power_of_two(long k) {
    const dumbbell::Rational power(dumbbell::Integer(1) << static_cast<unsigned>(k < 0 ? -k : k));
    return k < 0 ? dumbbell::Rational(1) / power : power;
}

/// Of either sign, |x| = 2^-k, 0 <= k <= most; or 0.
[[nodiscard]] inline dumbbell::Rational small_number(Choices& choices, std::size_t most = 120) {
    const std::size_t pick = choices.below(2 * most + 3);
    const dumbbell::Rational size = power_of_two(-static_cast<long>(pick / 2));
    return pick == 2 * most + 2 ? dumbbell::Rational(0) : pick % 2 == 0 ? size : -size;
}

/// The first node after the subtree that begins at `node`.
[[nodiscard]] inline std::size_t end_of_subtree(const dumbbell::collisions::Tree& tree, std::size_t node) {
    for (std::size_t missing = 1; missing > 0; ++node) missing = tree[node].split ? missing + 1 : missing - 1;
    return node;
}

/// Any leaf; it need not be one of this chart.
[[nodiscard]] inline dumbbell::collisions::Node any_leaf(Choices& choices) {
    using dumbbell::collisions::Reason;
    constexpr Reason reasons[] = {Reason::count, Reason::outside, Reason::meets, Reason::meets_reversed,
                                  Reason::once};
    const Reason reason = reasons[choices.below(5)];
    if (reason != Reason::count) return {std::nullopt, {reason}};
    const long forward = choices.between(0, 15);
    return {std::nullopt, {reason, forward, choices.between(0, 15)}};
}

[[nodiscard]] inline dumbbell::collisions::Axis any_axis(Choices& choices) {
    using dumbbell::collisions::Axis;
    constexpr Axis axes[] = {Axis::position, Axis::slope, Axis::ratio};
    return axes[choices.below(3)];
}

/// Any tree of at most about 2 * `splits` nodes.
inline void grow_any_tree(Choices& choices, std::size_t splits, dumbbell::collisions::Tree& tree) {
    const std::size_t here = splits == 0 ? 0 : choices.below(splits + 1);
    if (here == 0) {
        tree.push_back(any_leaf(choices));
        return;
    }
    tree.push_back({any_axis(choices), {}});
    const std::size_t lower = choices.below(here);
    grow_any_tree(choices, lower, tree);
    grow_any_tree(choices, here - 1 - lower, tree);
}

}  // namespace dumbbell_fuzz
