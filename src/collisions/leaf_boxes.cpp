#include "collisions/leaf_boxes.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/chart.hpp"

namespace dumbbell::collisions {
namespace {

constexpr int most_splits = 400;  // of one axis above a node (format.md): bounds the ends' size

/// A node's box, and how often each axis was split for it.
struct Waiting {
    BoxEnds box;
    std::array<int, axis_count> splits{};
};

/// 2^k with the least integer k >= 0 such that 2^k >= bound.
Rational power_of_two_for(const Rational& bound) {
    Integer power = 1;
    while (Rational(power) < bound) {
        power <<= 1;
    }
    return power;
}

/// The greatest position: e <= 2 (format.md 3.1, format-sections.md), t <= 4.
Rational greatest_position(const ChartRow& chart) { return chart.position == "t" ? 4 : 2; }

Rational greatest_slope(const ChartRow& chart, const Rational& q_hi) {
    return chart.name == "departure" ? Rational(2)
                                     : power_of_two_for(chart.position == "t" ? q_hi + 1 : q_hi);
}

}  // namespace

BoxEnds Boxes::box(const std::array<Rational, axis_count>& lo, const std::array<Rational, axis_count>& hi) {
    BoxEnds ends;
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
        ends.lo[axis] = static_cast<std::uint32_t>(values[axis].size());
        ends.hi[axis] = ends.lo[axis] + 1;
        values[axis].push_back(lo[axis]);
        values[axis].push_back(hi[axis]);
    }
    return ends;
}

Boxes root_of(Chart chart, const Rational& q_lo, const Rational& q_hi) {
    Boxes boxes;
    boxes.root = boxes.box({0, 0, q_lo},
                           {greatest_position(row_of(chart)), greatest_slope(row_of(chart), q_hi), q_hi});
    return boxes;
}

Boxes leaf_boxes(Chart chart, const Rational& q_lo, const Rational& q_hi, const Tree& tree) {
    Boxes boxes = root_of(chart, q_lo, q_hi);
    std::vector<Waiting> waiting{{boxes.root}};  // the nodes to come: the next one last
    for (const Node& node : tree) {
        if (waiting.empty()) {
            throw InputError("nodes follow the end of a tree");
        }
        auto [box, splits] = waiting.back();
        waiting.pop_back();
        if (!node.split) {
            boxes.leaves.push_back(box);
            continue;
        }
        const std::size_t axis = static_cast<std::size_t>(*node.split);
        if (++splits[axis] > most_splits) {
            throw InputError(
                fmt::format("a tree splits an axis more than {} times above a node", most_splits));
        }
        const auto middle = static_cast<std::uint32_t>(boxes.values[axis].size());
        boxes.values[axis].push_back((boxes.lo(box, axis) + boxes.hi(box, axis)) / 2);
        BoxEnds lower = box;
        BoxEnds upper = box;
        lower.hi[axis] = middle;
        upper.lo[axis] = middle;
        waiting.push_back({upper, splits});
        waiting.push_back({lower, splits});
    }
    return boxes;
}

}  // namespace dumbbell::collisions
