#include "starts/cover/subdivide.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "number/parallel.hpp"
#include "starts/air/box_state.hpp"
#include "starts/cover/incoming.hpp"
#include "starts/cover/leaf.hpp"
#include "starts/cover/spread.hpp"
#include "starts/walls/find_obstacle.hpp"
#include "starts/walls/follow.hpp"

namespace dumbbell::starts {
namespace {

constexpr std::size_t boxes_together = 16;
constexpr std::size_t boxes_at_a_time = 4096;  ///< that are judged before their results are packed

struct Judged {
    Leaf leaf;
    std::optional<Axis> split;  ///< of a box that may be halved
    std::optional<Box> states;  ///< that are undecided, unless they have no bound

    [[nodiscard]] bool is_exact() const { return leaf.most == leaf.least; }
};

/// The axis to halve, where so many collisions are certain; nothing if none may be.
std::optional<Axis> split_axis(const Box& box, const decltype(Place::depths)& depths, long certain,
                               int max_depth) {
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

Judged judge_states(Box states, const decltype(Place::depths)& depths, const SubdivideOptions& options) {
    Judged result{judge(states, options.bits), {}, {}};
    if (!result.is_exact()) {
        result.split = split_axis(states, depths, result.leaf.least, options.max_depth);
        result.states = std::move(states);
    }
    return result;
}

Judged judge(const Place& place, const Box& root, const SubdivideOptions& options) {
    const Box box = place.in(root);
    if (!options.incoming) {
        return judge_states(box, place.depths, options);
    }
    if (!is_unbounded(box)) {
        return judge_states(states_of_incoming(box), place.depths, options);
    }
    const bool may = place.depths[static_cast<std::size_t>(Axis::phidot)] < options.max_depth;
    return {judge_falling(box), may ? std::optional(Axis::phidot) : std::nullopt, {}};
}

void include(Subdivision& result, const Leaf& leaf, std::size_t depth) {
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

/// What an undecided box is on or near to.
Obstacle obstacle_of(const Judged& undecided) {
    if (!undecided.states) {
        return Obstacle::other;
    }
    const auto s = natural_state<Interval>(*undecided.states);
    return find_obstacle(follow(s, spans_of_a_box), s);
}

/// Grows the tree, and adds up its leaves.
class Growth {
  public:
    Growth(const Box& box, const SubdivideOptions& options) : box_(box), options_(options) {
        result_.bits = options.bits;
    }

    Subdivision run() {
        for (bool grows = true; grows; ++generation_) {
            grows = false;
            result_.tree.for_each_place(generation_, [&](const Place& place) {
                grows = true;
                places_.push_back(place);
                if (places_.size() == boxes_at_a_time) {
                    grow();
                }
            });
            grow();
        }
        return std::move(result_);
    }

  private:
    /// The nodes of these places; the results do not depend on how the work is shared out.
    void grow() {
        const std::vector<Place> places = std::exchange(places_, {});
        std::vector<Judged> judged(places.size());
        in_parallel(places.size(), boxes_together, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i) {
                judged[i] = judge(places[i], box_, options_);
            }
            options_.observer->advance(end - begin);
        });
        const bool stop = options_.interrupted();
        std::vector<const Judged*> undecided;
        for (const Judged& one : judged) {
            const auto& [leaf, split, states] = one;
            if (split && !stop && leaves_ < options_.max_boxes) {
                ++leaves_;
                result_.tree.add(generation_, {*split, {}});
                continue;
            }
            result_.tree.add(generation_, {{}, leaf});
            include(result_, leaf, generation_);
            if (!one.is_exact()) {
                undecided.push_back(&one);
            }
        }
        if (stop) {
            result_.unexplained += static_cast<long>(undecided.size());
        } else {
            explain(undecided);
        }
    }

    /// Names what these are on or near to.
    void explain(const std::vector<const Judged*>& undecided) {
        std::vector<Obstacle> found(undecided.size());
        in_parallel(found.size(), boxes_together, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i) {
                found[i] = obstacle_of(*undecided[i]);
            }
        });
        for (const Obstacle obstacle : found) {
            ++result_.near.at(static_cast<std::size_t>(obstacle));
        }
    }

    const Box& box_;
    const SubdivideOptions& options_;
    Subdivision result_;
    std::size_t leaves_ = 1;
    std::size_t generation_ = 0;
    std::vector<Place> places_;  ///< of this generation, the next to be judged
};

}  // namespace

Subdivision subdivide(const Box& box, const SubdivideOptions& options) {
    return with_threads(options.jobs, [&] { return Growth(box, options).run(); });
}

}  // namespace dumbbell::starts
