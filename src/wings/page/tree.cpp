#include "page/tree.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "base/error.hpp"

namespace dumbbell::page {
namespace {

/// Of the subtree that begins at a node: its leaves, the greatest kind of them, and the node after it.
struct Subtree {
    std::size_t leaves = 1;
    int greatest = 0;
    std::size_t end = 0;
};

/// A subtree that is not shown in detail so far.
struct Closed {
    std::size_t node;
    double weight;  // its leaves times the square root of its share of the root box
    int depth;
};

std::vector<Subtree> subtrees_of(const PictureTree& tree) {
    std::vector<Subtree> subtrees(tree.size());
    std::vector<std::size_t> roots;  // of the complete subtrees after the node: the next one last
    for (std::size_t i = tree.size(); i-- > 0;) {
        if (tree[i] >= 0) {
            subtrees[i] = {1, tree[i], i + 1};
        } else {
            require(roots.size() >= 2, "picture: a tree is not complete");
            const Subtree& lower = subtrees[roots.back()];
            roots.pop_back();
            const Subtree& upper = subtrees[roots.back()];
            roots.pop_back();
            subtrees[i] = {lower.leaves + upper.leaves, std::max(lower.greatest, upper.greatest), upper.end};
        }
        roots.push_back(i);
    }
    require(roots.size() == 1, "picture: a tree is not complete");
    return subtrees;
}

/// The inner nodes that are drawn as such.
std::vector<bool> opened(const PictureTree& tree, const std::vector<Subtree>& subtrees, std::size_t most) {
    std::vector<bool> open(tree.size());
    const auto lighter = [](const Closed& a, const Closed& b) {
        return a.weight != b.weight ? a.weight < b.weight : a.node > b.node;
    };
    std::priority_queue<Closed, std::vector<Closed>, decltype(lighter)> closed(lighter);
    const auto add = [&](std::size_t node, int depth) {
        if (tree[node] < 0) {
            closed.push({node, static_cast<double>(subtrees[node].leaves) * std::exp2(-depth / 2.0), depth});
        }
    };
    add(0, 0);
    for (std::size_t shown = 1; shown < most && !closed.empty(); ++shown) {
        const auto [node, weight, depth] = closed.top();
        closed.pop();
        open[node] = true;
        add(node + 1, depth + 1);
        add(subtrees[node + 1].end, depth + 1);
    }
    return open;
}

}  // namespace

ThinnedTree thinned(const PictureTree& tree, std::size_t most) {
    const auto subtrees = subtrees_of(tree);
    if (subtrees[0].leaves <= most) {
        return {tree, {}};
    }
    const auto open = opened(tree, subtrees, most);
    ThinnedTree result;
    for (std::size_t i = 0; i < tree.size();) {
        if (open[i]) {
            result.nodes.push_back(tree[i++]);
            continue;
        }
        result.nodes.push_back(subtrees[i].greatest);
        result.stands_for.push_back(subtrees[i].leaves);
        i = subtrees[i].end;
    }
    return result;
}

std::size_t share_of(std::size_t leaves, const BoxBudget& budget) {
    if (budget.total <= budget.most) {
        return leaves;
    }
    const double share = static_cast<double>(budget.most) / static_cast<double>(budget.total);
    return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(leaves)));
}

Json tree_json(const PictureTree& tree, const BoxBudget& budget) {
    const std::size_t leaves = leaves_of(tree);
    const ThinnedTree drawn = thinned(tree, share_of(leaves, budget));
    return Json::object({{"nodes", Json::array(drawn.nodes)},
                         {"leaves", leaves},
                         {"stands_for", Json::array(drawn.stands_for)}});
}

}  // namespace dumbbell::page
