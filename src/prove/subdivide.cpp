#include "prove/subdivide.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "arith/self_test.hpp"
#include "model/follow.hpp"
#include "prove/initial_leaf.hpp"
#include "prove/initial_state.hpp"

namespace dumbbell {
namespace {

/// A node of the growing tree: its children stand side by side from `lower_child` on.
struct Draft {
    std::optional<InitialAxis> split;
    InitialLeaf leaf{};
    std::size_t lower_child = 0;
    int depth = 0;
};

/// A box that waits to be judged, with the number of splits of each axis above it.
struct Pending {
    std::size_t node;
    InitialBox box;
    std::array<int, initial_axes> depth;
};

struct Judged {
    InitialLeaf leaf;
    std::optional<InitialAxis> split;  ///< of a box that may be halved
};

/// How much each axis spreads the box's orbits where they part, from the derivatives of the centre's orbit: a
/// guess that only decides which axis is halved.
std::array<double, initial_axes> spreads(const InitialBox& box, std::size_t collisions) {
    InitialBox centre;
    for (std::size_t i = 0; i < initial_axes; ++i) {
        centre.lo[i] = centre.hi[i] = (box.lo[i] + box.hi[i]) / 2;
    }
    const BoxJets<Interval> jets(centre);
    const auto start = jets.state();
    const auto followed = follow(start);
    const std::size_t shared = std::min(collisions + 1, followed.bounces.size());
    const auto& s = shared == 0 ? start : followed.bounces[shared - 1].after;
    const double spin = approximate(range(s.phidot));
    const double climb = approximate(range(s.yhatdot));
    const double r = approximate(range(s.r));
    const double speed = std::hypot(spin, climb / std::sqrt(r));
    std::array<double, initial_axes> spread{};
    for (std::size_t i = 0; i < initial_axes; ++i) {
        const auto change = [&](const Jet<Interval>& x) {
            return std::abs(approximate(x.gradient()[static_cast<int>(i)]));
        };
        const double sum =
            change(s.phi) + change(s.yhat) + (change(s.phidot) + change(s.yhatdot) / r) / std::abs(speed);
        spread[i] = (box.hi[i] - box.lo[i]).convert_to<double>() * (std::isfinite(sum) ? sum : 1);
    }
    return spread;
}

/// The axis to halve; nothing if none may be.
std::optional<InitialAxis> split_axis(const Pending& pending, std::size_t collisions, int max_depth) {
    const auto spread = spreads(pending.box, collisions);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < initial_axes; ++i) {
        const bool may = pending.box.lo[i] != pending.box.hi[i] && pending.depth[i] < max_depth;
        if (may && (!best || spread[i] > spread[*best])) {
            best = i;
        }
    }
    return best ? std::optional(static_cast<InitialAxis>(*best)) : std::nullopt;
}

Judged judge(const Pending& pending, const SubdivideOptions& options) {
    Judged result{judge_initial(pending.box, options.bits), std::nullopt};
    if (result.leaf.most != result.leaf.least) {
        result.split = split_axis(pending, static_cast<std::size_t>(result.leaf.least), options.max_depth);
    }
    return result;
}

/// The boxes of one generation; the results do not depend on how the work is shared out.
std::vector<Judged> judge_all(const std::vector<Pending>& pending, const SubdivideOptions& options) {
    std::vector<Judged> results(pending.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pending.size(), 16), [&](const auto& range) {
        require_sound_arithmetic();
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            results[i] = judge(pending[i], options);
        }
    });
    return results;
}

std::array<InitialBox, 2> halves(const InitialBox& box, InitialAxis axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Rational middle = (box.lo[i] + box.hi[i]) / 2;
    std::array<InitialBox, 2> result{box, box};
    result[0].hi[i] = middle;
    result[1].lo[i] = middle;
    return result;
}

/// Grows the tree by generations.
std::vector<Draft> grow(const InitialBox& box, const SubdivideOptions& options) {
    std::vector<Draft> drafts(1);
    std::vector<Pending> pending{{0, box, {}}};
    std::size_t leaves = 1;
    while (!pending.empty()) {
        const std::vector<Judged> judged = judge_all(pending, options);
        const bool stop = options.interrupted();
        std::vector<Pending> next;
        for (std::size_t i = 0; i < pending.size(); ++i) {
            const std::size_t node = pending[i].node;
            if (!judged[i].split || stop || leaves >= options.max_boxes) {
                drafts[node].leaf = judged[i].leaf;
                continue;
            }
            ++leaves;
            drafts[node].split = judged[i].split;
            drafts[node].lower_child = drafts.size();
            auto depth = pending[i].depth;
            ++depth[static_cast<std::size_t>(*judged[i].split)];
            for (InitialBox& half : halves(pending[i].box, *judged[i].split)) {
                next.push_back({drafts.size(), std::move(half), depth});
                drafts.push_back(
                    {.split = {}, .leaf = {}, .lower_child = 0, .depth = drafts[node].depth + 1});
            }
        }
        pending = std::move(next);
    }
    return drafts;
}

void include(Subdivision& result, const InitialLeaf& leaf, int depth) {
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

}  // namespace

Subdivision subdivide(const InitialBox& box, const SubdivideOptions& options) {
    tbb::task_arena arena(options.jobs);
    const std::vector<Draft> drafts = arena.execute([&] { return grow(box, options); });
    Subdivision result;
    result.bits = options.bits;
    std::vector<std::size_t> stack{0};
    while (!stack.empty()) {
        const Draft& draft = drafts[stack.back()];
        stack.pop_back();
        result.tree.push_back({draft.split, draft.leaf});
        if (draft.split) {
            stack.push_back(draft.lower_child + 1);
            stack.push_back(draft.lower_child);
        } else {
            include(result, draft.leaf, draft.depth);
        }
    }
    return result;
}

}  // namespace dumbbell
