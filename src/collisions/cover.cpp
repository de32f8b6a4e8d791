#include "collisions/cover.hpp"

#include <algorithm>
#include <type_traits>

#include "base/error.hpp"
#include "base/growing_tree.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {
namespace {

/// A box in double is soon judged; one in multiple precision is work enough for a thread.
template <class I>
constexpr std::size_t boxes_together = std::is_same_v<I, Interval> ? 16 : 1;

/// Enough for many threads, and little memory.
constexpr std::size_t boxes_in_memory = 4096;

/// The boxes of one generation; the results do not depend on how the work is shared out.
template <class I>
void judge_all(Chart chart, std::span<const Box> boxes, const Count& upper,
               std::span<std::optional<Leaf>> results, const CoverOptions& options) {
    const std::size_t together = options.parallel ? boxes_together<I> : boxes.size();
    in_parallel(boxes.size(), together, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end && !options.interrupted(); ++i) {
            results[i] = judge<I>(chart, boxes[i], upper, options.interrupted);
        }
    });
}

/// Of which open boxes one axis seems to be what is too wide: the box that `thin` makes of it, of no width
/// there, closes. `thin` gives nothing for a box that is not to be asked about. To split only what
/// keeps a box open saves more boxes than asking costs: of `certify 1:1e6` 4,869 leaves count collisions,
/// where 12,188 did before.
template <class I, class Thin>
std::vector<bool> would_close(Chart chart, std::span<const Box> boxes,
                              std::span<const std::optional<Leaf>> results, const Count& upper,
                              const CoverOptions& options, Thin thin) {
    std::vector<std::size_t> asked;
    std::vector<Box> thinned;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (auto box = results[i] ? std::nullopt : thin(chart, boxes[i])) {
            asked.push_back(i);
            thinned.push_back(*std::move(box));
        }
    }
    std::vector<std::optional<Leaf>> answers(thinned.size());
    judge_all<I>(chart, thinned, upper, answers, options);
    std::vector<bool> wide(boxes.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        wide[asked[i]] = answers[i].has_value();
    }
    return wide;
}

double width(const Side& side) { return width(side.lo, side.hi); }

/// Only the greatest ratio (the least r, where most bounds are). Only while the ratio is not already narrow
/// against the state: at a ratio where the answer changes this would never end.
std::optional<Box> with_greatest_ratio(Chart chart, const Box& box) {
    const double state = std::max(width(box[Axis::position]), width(box[Axis::slope]));
    if (row_of(chart).needs_both_ratios ||
        16 * width(box[Axis::ratio]) <= state * approximate(box[Axis::ratio].lo)) {
        return std::nullopt;
    }
    Box thin = box;
    thin[Axis::ratio].lo = thin[Axis::ratio].hi;
    return thin;
}

Axis longest_side(Chart chart, const Box& box) {
    // How many units of slope one unit of position is worth.
    const double position_weight =
        row_of(chart).counts_at_least_position ? approximate(box[Axis::ratio].hi) : 1;
    const double position = width(box[Axis::position]) * position_weight;
    const double slope = width(box[Axis::slope]);
    // A relative change of the ratio moves a bound much less than the same change of a coordinate: plain
    // evaluation takes 3 to 6 times as many boxes with equal weights.
    const double ratio = width(box[Axis::ratio]) / (8 * approximate(box[Axis::ratio].lo));
    if (row_of(chart).needs_both_ratios && ratio > std::max(position, slope)) {
        return Axis::ratio;
    }
    return position > slope ? Axis::position : Axis::slope;
}

/// Both counts of a box of the light chart are at its least position (L9): the half that keeps it would be as
/// open as the box. Only the other reasons there depend on the greatest one.
bool is_bounded_at_least_position(Chart chart, const Box& box) {
    return row_of(chart).counts_at_least_position && approximate(box[Axis::position].hi) <= 1;
}

/// Where those other reasons may be near: not while the slope is far beyond all turning collisions (up to 4),
/// and while the position is the longest side, for along the edge of what touches the bridge both are too
/// wide.
std::optional<Box> with_least_position(Chart chart, const Box& box) {
    if (!is_bounded_at_least_position(chart, box) || width(box[Axis::slope]) > 4 ||
        longest_side(chart, box) != Axis::position) {
        return std::nullopt;
    }
    Box thin = box;
    thin[Axis::position].hi = thin[Axis::position].lo;
    return thin;
}

Axis axis_to_split(Chart chart, const Box& box) {
    if (row_of(chart).splits_position_only) {
        return Axis::position;
    }
    if (is_bounded_at_least_position(chart, box)) {
        return Axis::slope;
    }
    return longest_side(chart, box);
}

}  // namespace

template <class I>
std::optional<Tree> cover(Chart chart, const Rational& q_lo, const Rational& q_hi, const Count& upper,
                          const CoverOptions& options) {
    require(upper >= 1, "cover: an upper bound is at least 1");
    Box root = root_box(chart, q_lo, q_hi);
    if (options.system.rho) {
        root.rho = *options.system.rho;
    }
    GrowingTree<Node, Box, axis_count> tree(std::move(root), boxes_in_memory);
    for (; !tree.boxes().empty(); tree.next_generation()) {
        const std::vector<Box>& boxes = tree.boxes();
        std::vector<std::optional<Leaf>> results(boxes.size());
        judge_all<I>(chart, boxes, upper, results, options);
        options.observer->advance(boxes.size());
        const auto by_ratio = would_close<I>(chart, boxes, results, upper, options, with_greatest_ratio);
        const auto by_position = would_close<I>(chart, boxes, results, upper, options, with_least_position);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (options.interrupted()) {
                return std::nullopt;
            }
            if (results[i]) {
                tree.close(i, *results[i]);
                continue;
            }
            const Axis axis = by_ratio[i]      ? Axis::ratio
                              : by_position[i] ? Axis::position
                                               : axis_to_split(chart, boxes[i]);
            if (tree.depths(i)[static_cast<std::size_t>(axis)] >= options.max_depth ||
                tree.nodes() + 2 > options.max_nodes) {
                return std::nullopt;
            }
            tree.split(i, axis, halves(boxes[i], axis));
        }
    }
    return std::move(tree).pre_order();
}

template std::optional<Tree> cover<Interval>(Chart, const Rational&, const Rational&, const Count&,
                                             const CoverOptions&);
template std::optional<Tree> cover<BigInterval>(Chart, const Rational&, const Rational&, const Count&,
                                                const CoverOptions&);

}  // namespace dumbbell::collisions
