#include "law/layer_cover.hpp"

#include "base/growing_tree.hpp"
#include "number/parallel.hpp"

namespace dumbbell::law {
namespace {

constexpr int most_splits = 24;  ///< of one axis

/// [lo, hi] of a side of length num/den.
Interval side(const std::pair<double, double>& share, int num, int den) {
    const Interval length = Interval(num) / Interval(den);
    return hull(Interval(share.first) * length, Interval(share.second) * length);
}

std::optional<LayerLeaf> judged(const LayerBox& box) {
    if (certainly_beyond(box)) {
        return LayerLeaf::beyond;
    }
    return closes(box) ? std::optional(LayerLeaf::slope) : std::nullopt;
}

LayerAxis longer_side(const LayerShares& shares) {
    const LayerBox box = shares.box();
    return width(box.rho) > width(box.U) ? LayerAxis::rho : LayerAxis::U;
}

}  // namespace

LayerBox LayerShares::box() const {
    LayerBox result{side(U, 9, 10), side(rho, 1, 5)};
    // Rounding must not lead below 0: 0 times a length is 0.
    if (U.first == 0) {
        result.U = Interval(0, result.U.hi());
    }
    if (rho.first == 0) {
        result.rho = Interval(0, result.rho.hi());
    }
    return result;
}

std::pair<LayerShares, LayerShares> LayerShares::halves(LayerAxis axis) const {
    std::pair<LayerShares, LayerShares> result{*this, *this};
    auto& lower = axis == LayerAxis::U ? result.first.U : result.first.rho;
    auto& upper = axis == LayerAxis::U ? result.second.U : result.second.rho;
    lower.second = upper.first = (lower.first + lower.second) / 2;
    return result;
}

std::optional<LayerTree> cover_layer(const Interrupted& interrupted, Observer& observer) {
    GrowingTree<LayerNode, LayerShares, 2> tree{LayerShares()};
    for (; !tree.boxes().empty(); tree.next_generation()) {
        const std::vector<LayerShares>& boxes = tree.boxes();
        std::vector<std::optional<LayerLeaf>> leaves(boxes.size());
        in_parallel(boxes.size(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end && !interrupted(); ++i) {
                leaves[i] = judged(boxes[i].box());
            }
            observer.advance(end - begin);
        });
        if (interrupted()) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (leaves[i]) {
                tree.close(i, *leaves[i]);
                continue;
            }
            const LayerAxis axis = longer_side(boxes[i]);
            if (tree.depths(i)[static_cast<std::size_t>(axis)] >= most_splits) {
                return std::nullopt;
            }
            tree.split(i, axis, boxes[i].halves(axis));
        }
    }
    return std::move(tree).pre_order();
}

}  // namespace dumbbell::law
