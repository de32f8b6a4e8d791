#include "audit/tiling.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <utility>

namespace dumbbell::audit {
namespace {

using collisions::BoxEnds;
using collisions::Boxes;
using Exact = CGAL::Gmpq;

Exact exact(const Rational& x) { return Exact(x.raw()); }

Rational rational(const Exact& x) { return Rational(x.mpq()); }

/// An axis on which the root has positive width, in units of the root: the root is [0, 1]. The map is exact
/// and increasing, so it changes neither order nor shares of the area; bisected coordinates become short
/// dyadics, and doubles separate them down to 53 splits, wherever the root lies.
struct UnitAxis {
    std::size_t axis;
    std::vector<Exact> values;
    std::vector<std::pair<double, double>> outward;  ///< doubles around each value

    UnitAxis(const Boxes& boxes, std::size_t number) : axis(number) {
        const Exact origin = exact(boxes.lo(boxes.root, axis));
        const Exact width = exact(boxes.hi(boxes.root, axis)) - origin;
        values.reserve(boxes.values[axis].size());
        outward.reserve(boxes.values[axis].size());
        for (const Rational& x : boxes.values[axis]) {
            values.push_back((exact(x) - origin) / width);
            outward.push_back(CGAL::to_interval(values.back()));
        }
    }

    [[nodiscard]] const Exact& lo(const BoxEnds& box) const { return values[box.lo[axis]]; }
    [[nodiscard]] const Exact& hi(const BoxEnds& box) const { return values[box.hi[axis]]; }
};

std::vector<UnitAxis> unit_axes(const Boxes& boxes) {
    std::vector<UnitAxis> result;
    for (std::size_t axis = 0; axis < collisions::axis_count; ++axis) {
        if (boxes.lo(boxes.root, axis) < boxes.hi(boxes.root, axis)) {
            result.emplace_back(boxes, axis);
        }
    }
    return result;
}

/// The root's area, of the axes of positive width.
Rational area_of(const Boxes& boxes, const std::vector<UnitAxis>& axes_in_use) {
    Rational area = 1;
    for (const UnitAxis& unit : axes_in_use) {
        area *= boxes.hi(boxes.root, unit.axis) - boxes.lo(boxes.root, unit.axis);
    }
    return area;
}

std::optional<Fault> fault_alone(const Boxes& boxes, const BoxEnds& box) {
    for (std::size_t axis = 0; axis < collisions::axis_count; ++axis) {
        if (boxes.hi(box, axis) < boxes.lo(box, axis)) {
            return Fault::reversed;
        }
        if (boxes.lo(box, axis) < boxes.lo(boxes.root, axis) ||
            boxes.hi(boxes.root, axis) < boxes.hi(box, axis)) {
            return Fault::sticks_out;
        }
    }
    return std::nullopt;
}

bool interiors_meet(const std::vector<UnitAxis>& axes_in_use, const BoxEnds& a, const BoxEnds& b) {
    return std::all_of(axes_in_use.begin(), axes_in_use.end(), [&](const UnitAxis& unit) {
        return unit.lo(a) < unit.hi(b) && unit.lo(b) < unit.hi(a) && unit.lo(a) < unit.hi(a) &&
               unit.lo(b) < unit.hi(b);
    });
}

/// For CGAL's filter.
using FilterBox = CGAL::Box_intersection_d::Box_with_handle_d<double, collisions::axis_count, const BoxEnds*>;

/// A double box around a leaf. An axis that is not in use is [0, 1].
FilterBox filter_box(const std::vector<UnitAxis>& axes_in_use, const BoxEnds& leaf) {
    std::array<double, collisions::axis_count> lo{}, hi;
    hi.fill(1);
    for (std::size_t i = 0; i < axes_in_use.size(); ++i) {
        const UnitAxis& unit = axes_in_use[i];
        lo[i] = unit.outward[leaf.lo[unit.axis]].first;
        hi[i] = unit.outward[leaf.hi[unit.axis]].second;
    }
    return {lo.data(), hi.data(), &leaf};
}

/// Thrown to leave CGAL's loop.
using Overlap = std::pair<const BoxEnds*, const BoxEnds*>;

/// Compares exactly every pair of leaves whose closed double boxes meet.
void look_for_overlap(const Boxes& boxes, const std::vector<UnitAxis>& axes_in_use, Tiling& tiling) {
    std::vector<FilterBox> filter;
    filter.reserve(boxes.leaves.size());
    for (const BoxEnds& leaf : boxes.leaves) {
        filter.push_back(filter_box(axes_in_use, leaf));
    }
    try {
        CGAL::box_self_intersection_d(filter.begin(), filter.end(),
                                      [&](const FilterBox& a, const FilterBox& b) {
                                          ++tiling.pairs;
                                          if (interiors_meet(axes_in_use, *a.handle(), *b.handle())) {
                                              throw Overlap(std::minmax({a.handle(), b.handle()}));
                                          }
                                      });
    } catch (const Overlap& overlap) {
        tiling.fault = Fault::overlap;
        tiling.first = static_cast<std::size_t>(overlap.first - boxes.leaves.data());
        tiling.second = static_cast<std::size_t>(overlap.second - boxes.leaves.data());
    }
}

/// The share of the root's area that the leaves have together.
Exact share_of(const Boxes& boxes, const std::vector<UnitAxis>& axes_in_use) {
    Exact sum = 0;
    for (const BoxEnds& leaf : boxes.leaves) {
        Exact share = 1;
        for (const UnitAxis& unit : axes_in_use) {
            share *= unit.hi(leaf) - unit.lo(leaf);
        }
        sum += share;
    }
    return sum;
}

}  // namespace

void need_exact_geometry() {}

Tiling check_tiling(const Boxes& boxes, const TilingProgress& progress) {
    Tiling tiling;
    tiling.leaves = boxes.leaves.size();
    for (std::size_t i = 0; i < boxes.leaves.size(); ++i) {
        tiling.fault = fault_alone(boxes, boxes.leaves[i]);
        if (tiling.fault) {
            tiling.first = i;
            return tiling;
        }
    }
    const std::vector<UnitAxis> axes_in_use = unit_axes(boxes);
    tiling.area = area_of(boxes, axes_in_use);
    progress(0.3);
    look_for_overlap(boxes, axes_in_use, tiling);
    if (tiling.fault) {
        return tiling;
    }
    progress(0.9);
    const Exact share = share_of(boxes, axes_in_use);
    if (share != 1) {
        tiling.fault = Fault::missing_area;
        tiling.missing = rational(1 - share) * tiling.area;
    }
    return tiling;
}

}  // namespace dumbbell::audit
