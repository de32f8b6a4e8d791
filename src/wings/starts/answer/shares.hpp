#pragma once

#include <optional>
#include <string>
#include <vector>

#include "starts/cover/packed_tree.hpp"
#include "words/json.hpp"

/// How likely each number of collisions is: what the leaves of a tree prove of it (format-initial.md, 7).
namespace dumbbell::starts {

/// For every k from `least` to `most` (no end: none) shares of the box's volume, exactly: at least `lo` is of
/// starts that have exactly k collisions or meet a corner, at most `hi` of starts that have exactly k and
/// meet none.
struct ShareBounds {
    long least = 0;
    std::optional<long> most;
    Rational lo;
    Rational hi;
};

/// In ascending order, from k = 0 on; what follows the last one has the share 0. `lo` is the volume of the
/// leaves whose number is k, `hi` that of the leaves whose bounds have k between them. Precondition: a
/// complete tree.
[[nodiscard]] std::vector<ShareBounds> share_bounds(const PackedTree& tree);
[[nodiscard]] std::vector<ShareBounds> share_bounds(const std::vector<Node>& tree);

/// Bounds of the mean number of collisions of starts drawn evenly from the box; no `hi` if a leaf is open.
/// Precondition: a complete tree.
struct MeanBounds {
    Rational lo;
    std::optional<Rational> hi;
};
[[nodiscard]] MeanBounds mean_bounds(const PackedTree& tree);

/// A line for each, `3`, `4-6` or `7-` collisions, with twelve decimals rounded outward: as dumbbell-verify
/// --shares prints them.
[[nodiscard]] std::string share_lines(const std::vector<ShareBounds>& bounds);
[[nodiscard]] Json share_json(const std::vector<ShareBounds>& bounds);

}  // namespace dumbbell::starts
