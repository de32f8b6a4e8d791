#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace dumbbell {

/// A bisection tree that grows by generations: the boxes of one generation wait together, each is closed with
/// a leaf or halved, and the halves are the next generation. Node: a node of the tree in pre-order, with an
/// optional axis `split` and a `leaf`.
template <class Node, class Box, std::size_t axes>
class GrowingTree {
  public:
    using Depths = std::array<int, axes>;

    explicit GrowingTree(Box root) : boxes_{std::move(root)}, waiting_(1), drafts_(1) {}

    /// Of this generation; none: the tree is complete.
    [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
    /// The number of splits of each axis above a box of this generation.
    [[nodiscard]] const Depths& depths(std::size_t i) const { return waiting_[i].depths; }
    [[nodiscard]] std::size_t nodes() const { return drafts_.size(); }

    template <class Leaf>
    void close(std::size_t i, const Leaf& leaf) {
        drafts_[waiting_[i].draft].node.leaf = leaf;
    }
    template <class Axis>
    void split(std::size_t i, Axis axis, std::pair<Box, Box> halves) {
        Draft& parent = drafts_[waiting_[i].draft];
        parent.node.split = axis;
        parent.lower_child = drafts_.size();
        Depths depths = waiting_[i].depths;
        ++depths[static_cast<std::size_t>(axis)];
        for (Box* half : {&halves.first, &halves.second}) {
            next_waiting_.push_back({drafts_.size(), depths});
            next_boxes_.push_back(std::move(*half));
            drafts_.emplace_back();
        }
    }
    /// Every box of this generation was closed or split.
    void next_generation() {
        boxes_ = std::exchange(next_boxes_, {});
        waiting_ = std::exchange(next_waiting_, {});
    }

    [[nodiscard]] std::vector<Node> pre_order() const {
        std::vector<Node> nodes;
        nodes.reserve(drafts_.size());
        std::vector<std::size_t> stack{0};
        while (!stack.empty()) {
            const Draft& draft = drafts_[stack.back()];
            stack.pop_back();
            nodes.push_back(draft.node);
            if (draft.node.split) {
                stack.push_back(draft.lower_child + 1);
                stack.push_back(draft.lower_child);
            }
        }
        return nodes;
    }

  private:
    /// The children of a split node stand side by side from `lower_child` on.
    struct Draft {
        Node node{};
        std::size_t lower_child = 0;
    };
    struct Waiting {
        std::size_t draft = 0;
        Depths depths{};
    };

    std::vector<Box> boxes_, next_boxes_;
    std::vector<Waiting> waiting_, next_waiting_;
    std::vector<Draft> drafts_;
};

}  // namespace dumbbell
