#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "law/layer_rule.hpp"

/// The cover of the layer: a bisection tree of (U, rho) in [0, 9/10] x [0, 1/5].
namespace dumbbell::law {

enum class LayerAxis { U, rho };
/// The rule closes the box; beyond: it has no step with eps <= 1/1000.
enum class LayerLeaf { slope, beyond };

/// Without `split` a leaf.
struct LayerNode {
    std::optional<LayerAxis> split;
    LayerLeaf leaf = LayerLeaf::beyond;
};
using LayerTree = std::vector<LayerNode>;  ///< pre-order, lower half first

/// A box of the tree as shares of the root's sides, exactly.
struct LayerShares {
    std::pair<double, double> U{0, 1}, rho{0, 1};

    [[nodiscard]] LayerBox box() const;
    [[nodiscard]] std::pair<LayerShares, LayerShares> halves(LayerAxis axis) const;
};

/// Nothing if interrupted, or if a box can not be closed. Judges on all of the calling arena's threads; the
/// tree does not depend on their number. The observer is told of boxes that are judged.
[[nodiscard]] std::optional<LayerTree> cover_layer(const Interrupted& interrupted,
                                                   Observer& observer = nobody);

}  // namespace dumbbell::law
