// Certificates as lines, words and trees of lines, and the trailer that belongs to them. Nothing here knows
// what is true: broken text is welcome.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dumbbell_mutation {

using Words = std::vector<std::string>;
using Lines = std::vector<std::string>;  ///< without their line feeds

[[nodiscard]] Lines lines_of(std::string_view text);
[[nodiscard]] std::string text_of(const Lines& lines);
[[nodiscard]] Words words_of(std::string_view line);
[[nodiscard]] std::string line_of(const Words& words);

/// The text up to its first line `total` or `sha256`.
[[nodiscard]] std::string body_of(const std::string& text);
/// The body with a trailer that fits it, and in a file about initial conditions with the line `between` that
/// the leaves imply: nothing but the change itself is wrong.
[[nodiscard]] std::string closed(const std::string& text);
/// The text with the checksum that fits it; the totals stay as they are.
[[nodiscard]] std::string hashed(const std::string& text);

[[nodiscard]] bool is_initial(const Lines& lines);
[[nodiscard]] bool is_adiabatic(const Lines& lines);

/// A node of a tree in pre-order: its subtree is lines [begin, end); the second half's begins at `upper`, 0
/// for a leaf. Nodes of one tree have the same `tree`, the line of its root.
struct TreeNode {
    std::size_t begin = 0, end = 0, upper = 0, tree = 0;
};
/// The nodes of all complete trees of a file: after each line `chart`; after the header's `between`; after
/// the cells of a class, after `end`, or of a bounce after the header's `bound`.
[[nodiscard]] std::vector<TreeNode> nodes_of(const Lines& lines);

}  // namespace dumbbell_mutation
