#include "collisions/chart.hpp"

namespace dumbbell::collisions {
namespace {

/// In the order of Chart.
constexpr std::array chart_rows{&bridge_chart,    &light_chart,         &contact_chart,
                                &departure_chart, &plain_contact_chart, &plain_departure_chart,
                                &again_chart};

/// The least power of two that is >= x, and >= 1.
double power_of_two_from(const Rational& x) {
    double power = 1;
    while (exact(power) < x) {
        power *= 2;
    }
    return power;
}

}  // namespace

const ChartRow& row_of(Chart chart) { return *chart_rows.at(static_cast<std::size_t>(chart)); }

std::string_view axis_name(Chart chart, Axis axis) {
    const ChartRow& row = row_of(chart);
    return std::array{row.position, row.slope, std::string_view("q")}.at(static_cast<std::size_t>(axis));
}

std::optional<Axis> axis_named(Chart chart, std::string_view word) {
    for (const Axis axis : all_axes) {
        if (word == axis_name(chart, axis)) {
            return axis;
        }
    }
    return std::nullopt;
}

Box root_box(Chart chart, const Rational& q_lo, const Rational& q_hi) {
    const ChartRow& row = row_of(chart);
    const double steepest =
        row.greatest_slope > 0 ? row.greatest_slope : power_of_two_from(q_hi + row.slope_beyond);
    return {.sides = {{{0, row.greatest_position}, {0, steepest}, {q_lo, q_hi}}}};
}

std::pair<Box, Box> halves(const Box& box, Axis axis) {
    const Coordinate half = middle(box[axis].lo, box[axis].hi);
    Box lower = box, upper = box;
    lower[axis].hi = half;
    upper[axis].lo = half;
    return {std::move(lower), std::move(upper)};
}

}  // namespace dumbbell::collisions
