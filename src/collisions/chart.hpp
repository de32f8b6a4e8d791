#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "collisions/coordinate.hpp"

/// Charts and their boxes. A new chart is a value of Chart, a row in its section's file, and a line in
/// chart.cpp.
namespace dumbbell::collisions {

struct Side {
    Coordinate lo = 0, hi = 0;
};

/// A box of states, exact: a side for each axis. What is no body has no rho, 0.
struct Box {
    std::array<Side, axis_count> sides;
    Coordinate rho = 0;

    [[nodiscard]] Side& operator[](Axis axis) { return sides[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] const Side& operator[](Axis axis) const { return sides[static_cast<std::size_t>(axis)]; }
};

/// The reason that closes a box for "no trajectory has more than `upper` collisions"; nothing where none is
/// certain, or where it was interrupted.
using Judge = std::optional<Leaf> (*)(const Box& box, const Count& upper, const Interrupted& interrupted);

/// One in Interval, and one in BigInterval, with the calling thread's precision.
struct Judges {
    Judge in_double, in_more;
};

struct ChartRow {
    std::string_view name, position, slope;  ///< in files
    double greatest_position;
    /// Slopes reach from 0 to this, or if it is 0 to the power of two from q + slope_beyond on.
    double greatest_slope = 0;
    int slope_beyond = 0;
    /// Whether a leaf `count` has two counts: of the ray and of the reversed incoming ray. The full section
    /// counts forward only.
    bool counts_both_ways = true;
    /// Whether the bounds use both ends of the ratio, so that its width counts like that of a state's
    /// coordinate.
    bool needs_both_ratios = false;
    bool splits_position_only = false;
    /// Whether both counts are at the least position e, if e <= 1; and a unit of e is worth q units of slope.
    bool counts_at_least_position = false;
    Judges judges;
    /// Whether the counts that would have to be less are certainly not: no precision closes the box. Only to
    /// save work.
    bool (*is_open)(const Box& box, long upper, const Interrupted& interrupted) = nullptr;
};

[[nodiscard]] const ChartRow& row_of(Chart chart);

/// What row_of gives, each defined where its section is.
extern const ChartRow bridge_chart, light_chart, contact_chart, departure_chart, plain_contact_chart,
    plain_departure_chart, again_chart;

[[nodiscard]] std::string_view axis_name(Chart chart, Axis axis);
/// The other way round; nothing for an unknown word.
[[nodiscard]] std::optional<Axis> axis_named(Chart chart, std::string_view word);

/// The root box of a chart over mass ratios [q_lo, q_hi] (format.md): short dyadics that contain the chart's
/// states, and a slope range that holds all slopes in play.
[[nodiscard]] Box root_box(Chart chart, const Rational& q_lo, const Rational& q_hi);

/// The lower and the upper half; the midpoint is exact and belongs to both.
[[nodiscard]] std::pair<Box, Box> halves(const Box& box, Axis axis);

}  // namespace dumbbell::collisions
