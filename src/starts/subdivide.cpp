#include "starts/subdivide.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/growing_tree.hpp"
#include "number/parallel.hpp"
#include "starts/box_state.hpp"
#include "starts/find_obstacle.hpp"
#include "starts/follow.hpp"
#include "starts/incoming.hpp"
#include "starts/leaf.hpp"
#include "starts/spread.hpp"

namespace dumbbell::starts {
namespace {

using Tree = GrowingTree<Node, Box, axis_count>;

constexpr std::size_t boxes_together = 16;

struct Judged {
    Leaf leaf;
    std::optional<Axis> split;  ///< of a box that may be halved
};

/// The axis to halve, where so many collisions are certain; nothing if none may be.
std::optional<Axis> split_axis(const Box& box, const Tree::Depths& depths, long certain, int max_depth) {
    const auto spread = spreads(box, certain + 1);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < axis_count; ++i) {
        const bool may = box.lo[i] != box.hi[i] && depths[i] < max_depth;
        if (may && (!best || spread[i] > spread[*best])) {
            best = i;
        }
    }
    return best ? std::optional(static_cast<Axis>(*best)) : std::nullopt;
}

Judged judge_states(const Box& box, const Tree::Depths& depths, const SubdivideOptions& options) {
    Judged result{judge(box, options.bits), std::nullopt};
    if (result.leaf.most != result.leaf.least) {
        result.split = split_axis(box, depths, result.leaf.least, options.max_depth);
    }
    return result;
}

Judged judge(const Box& box, const Tree::Depths& depths, const SubdivideOptions& options) {
    if (!options.incoming) {
        return judge_states(box, depths, options);
    }
    if (!is_unbounded(box)) {
        return judge_states(states_of_incoming(box), depths, options);
    }
    const bool may = depths[static_cast<std::size_t>(Axis::phidot)] < options.max_depth;
    return {judge_falling(box.lower(Axis::ratio)), may ? std::optional(Axis::phidot) : std::nullopt};
}

/// The boxes of one generation; the results do not depend on how the work is shared out.
std::vector<Judged> judge_all(const Tree& tree, const SubdivideOptions& options) {
    std::vector<Judged> results(tree.boxes().size());
    in_parallel(results.size(), boxes_together, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
            results[i] = judge(tree.boxes()[i], tree.depths(i), options);
        }
        options.observer->advance(end - begin);
    });
    return results;
}

std::pair<Box, Box> halves(const Box& box, Axis axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Rational middle = (box.lo[i] + box.hi[i]) / 2;
    std::pair<Box, Box> result{box, box};
    result.first.hi[i] = middle;
    result.second.lo[i] = middle;
    return result;
}

void include(Subdivision& result, const Leaf& leaf, int depth) {
    const Rational share(1, Integer(1) << static_cast<unsigned>(depth));
    const bool first = result.exact.empty() && result.undecided.boxes == 0;
    result.least = first ? leaf.least : std::min(result.least, leaf.least);
    if (first || (result.most && (!leaf.most || *leaf.most > *result.most))) {
        result.most = leaf.most;
    }
    Share& sum = leaf.most == leaf.least ? result.exact[leaf.least] : result.undecided;
    sum.share += share;
    ++sum.boxes;
}

Obstacle obstacle_of_states(const Box& box) {
    const auto s = natural_state<Interval>(box);
    return find_obstacle(follow(s, spans_of_a_box), s);
}

/// What an undecided box is on or near to.
Obstacle obstacle_in(const Box& box, bool incoming) {
    return !incoming           ? obstacle_of_states(box)
           : is_unbounded(box) ? Obstacle::other
                               : obstacle_of_states(states_of_incoming(box));
}

/// Names what the undecided among the boxes of a generation are on or near to.
void explain(Subdivision& result, const Tree& tree, const std::vector<std::size_t>& undecided,
             bool incoming) {
    std::vector<Obstacle> found(undecided.size());
    in_parallel(found.size(), boxes_together, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
            found[i] = obstacle_in(tree.boxes()[undecided[i]], incoming);
        }
    });
    for (const Obstacle obstacle : found) {
        ++result.near.at(static_cast<std::size_t>(obstacle));
    }
}

/// Grows the tree, and adds up its leaves.
Subdivision grow(const Box& box, const SubdivideOptions& options) {
    Subdivision result;
    result.bits = options.bits;
    Tree tree(box);
    for (std::size_t leaves = 1; !tree.boxes().empty(); tree.next_generation()) {
        const std::vector<Judged> judged = judge_all(tree, options);
        const bool stop = options.interrupted();
        std::vector<std::size_t> undecided;
        for (std::size_t i = 0; i < judged.size(); ++i) {
            if (!judged[i].split || stop || leaves >= options.max_boxes) {
                tree.close(i, judged[i].leaf);
                const auto& depths = tree.depths(i);
                include(result, judged[i].leaf, std::accumulate(depths.begin(), depths.end(), 0));
                if (judged[i].leaf.most != judged[i].leaf.least) {
                    undecided.push_back(i);
                }
                continue;
            }
            ++leaves;
            tree.split(i, *judged[i].split, halves(tree.boxes()[i], *judged[i].split));
        }
        if (stop || !options.name_obstacles) {
            result.unexplained += static_cast<long>(undecided.size());
        } else {
            explain(result, tree, undecided, options.incoming);
        }
    }
    result.tree = std::move(tree).pre_order();
    return result;
}

}  // namespace

Subdivision subdivide(const Box& box, const SubdivideOptions& options) {
    return with_threads(options.jobs, [&] { return grow(box, options); });
}

}  // namespace dumbbell::starts
