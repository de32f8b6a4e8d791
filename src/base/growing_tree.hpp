#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <forward_list>
#include <limits>
#include <utility>
#include <vector>

namespace dumbbell {

/// A bisection tree that grows by generations: the boxes of one generation wait together, and in their order
/// each is closed with a leaf or halved. The next generation is all boxes that are left, or the first of them
/// up to a limit: then few wait, and with them few nodes that stand behind them. Node: a node of the tree in
/// pre-order, with an optional axis `split` and a `leaf`.
template <class Node, class Box, std::size_t axes>
class GrowingTree {
  public:
    using Depths = std::array<int, axes>;

    explicit GrowingTree(Box root, std::size_t most_together = std::numeric_limits<std::size_t>::max())
        : most_together_(most_together), drafts_(1) {
        put_off(std::move(root), {drafts_.begin(), {}});
        next_generation();
    }

    /// Of this generation; none: the tree is complete.
    [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
    /// The number of splits of each axis above a box of this generation.
    [[nodiscard]] const Depths& depths(std::size_t i) const { return waiting_[i].depths; }
    [[nodiscard]] std::size_t nodes() const { return nodes_; }

    template <class Leaf>
    void close(std::size_t i, const Leaf& leaf) {
        Draft& draft = *waiting_[i].draft;
        draft.node.leaf = leaf;
        draft.decided = true;
    }
    template <class Axis>
    void split(std::size_t i, Axis axis, std::pair<Box, Box> halves) {
        auto [draft, depths] = waiting_[i];
        draft->node.split = axis;
        draft->decided = true;
        ++depths[static_cast<std::size_t>(axis)];
        const auto lower = drafts_.emplace_after(draft);
        put_off(std::move(halves.first), {lower, depths});
        put_off(std::move(halves.second), {drafts_.emplace_after(lower), depths});
        nodes_ += 2;
    }
    /// Every box of this generation was closed or split.
    void next_generation() {
        for (; !drafts_.empty() && drafts_.front().decided; drafts_.pop_front()) {
            finished_.push_back(std::move(drafts_.front().node));
        }
        move_last(new_boxes_, new_boxes_.size(), later_boxes_);
        move_last(new_, new_.size(), later_);
        const std::size_t size = std::min(later_.size(), most_together_);
        boxes_.clear();
        waiting_.clear();
        move_last(later_boxes_, size, boxes_);
        move_last(later_, size, waiting_);
    }

    /// Precondition: it is complete.
    [[nodiscard]] std::vector<Node> pre_order() && { return std::move(finished_); }

  private:
    /// A node that is not finished: it, or one in front of it, is not decided.
    struct Draft {
        Node node{};
        bool decided = false;
    };
    struct Waiting {
        typename std::forward_list<Draft>::iterator draft;
        Depths depths{};
    };

    void put_off(Box box, const Waiting& waiting) {
        new_boxes_.push_back(std::move(box));
        new_.push_back(waiting);
    }
    /// Moves the last n of `from` to the end of `to`, in reverse order.
    template <class T>
    static void move_last(std::vector<T>& from, std::size_t n, std::vector<T>& to) {
        for (; n > 0; --n) {
            to.push_back(std::move(from.back()));
            from.pop_back();
        }
    }

    std::size_t most_together_;
    std::size_t nodes_ = 1;
    std::vector<Node> finished_;       ///< in pre-order, as are all but those of later generations
    std::forward_list<Draft> drafts_;  ///< that follow them
    std::vector<Box> boxes_, new_boxes_, later_boxes_;  ///< later ones: in reverse order
    std::vector<Waiting> waiting_, new_, later_;
};

}  // namespace dumbbell
