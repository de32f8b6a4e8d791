#include "pictures/start_plane.hpp"

#include <fmt/core.h>

#include <array>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "number/decimal.hpp"

namespace dumbbell::pictures {

namespace {

constexpr std::array<const char*, starts::axis_count> meanings{
    "phi (angle of the rod, radians)", "phidot (angular velocity)",
    "y (height of the centre of mass, rod lengths)", "ydot (vertical velocity, downwards negative)",
    "q (mass ratio, heavy over light)"};

bool has_width(const starts::Box& box, std::size_t axis) { return box.lo[axis] < box.hi[axis]; }

std::string signed_text(const Rational& x) {
    return x == 0 ? "0" : x < 0 ? "\xe2\x88\x92" + exact_text(-x) : exact_text(x);
}

}  // namespace

StartPlane start_plane(const starts::Certificate& certificate) {
    std::vector<std::size_t> wide;
    for (std::size_t axis = 0; axis < starts::axis_count; ++axis) {
        if (has_width(certificate.box, axis)) {
            wide.push_back(axis);
        }
    }
    if (wide.size() != 2) {
        throw InputError(fmt::format(
            "a picture has two axes, and {} of phi, phidot, y, ydot and the mass ratio are intervals in "
            "this certificate: dumbbell trace with intervals for two of them",
            wide.size()));
    }
    StartPlane plane{{static_cast<starts::Axis>(wide[0]), static_cast<starts::Axis>(wide[1])}, {}};
    std::vector<PlaneBox> waiting{{{0, 0}, {1, 1}}};  // the nodes to come: the next one last
    for (const starts::Node& node : certificate.tree) {
        require(!waiting.empty(), "nodes follow the end of a tree of initial conditions");
        PlaneBox box = std::move(waiting.back());
        waiting.pop_back();
        if (!node.split) {
            plane.cells.push_back({std::move(box), node.leaf});
            continue;
        }
        if (*node.split != plane.axes[0] && *node.split != plane.axes[1]) {
            throw InputError("this certificate halves a quantity that is a single number");
        }
        const std::size_t axis = *node.split == plane.axes[0] ? 0 : 1;
        const Rational middle = (box.lo[axis] + box.hi[axis]) / 2;
        PlaneBox upper = box;
        upper.lo[axis] = middle;
        box.hi[axis] = middle;
        waiting.push_back(std::move(upper));
        waiting.push_back(std::move(box));
    }
    return plane;
}

PlotAxis plot_axis(const starts::Certificate& certificate, starts::Axis axis) {
    constexpr int wanted = 7;
    if (certificate.incoming && axis == starts::Axis::phi) {
        constexpr double turn = 2 * std::numbers::pi;
        return {0, turn, meanings.front(), angle_ticks(0, turn)};
    }
    if (certificate.incoming) {
        return {0, 1, "s (sine of the direction of flight against the vertical)", even_ticks(0, 1, wanted)};
    }
    const auto lo = certificate.box.lower(axis).convert_to<double>();
    const auto hi = certificate.box.upper(axis).convert_to<double>();
    return {lo, hi, meanings[static_cast<std::size_t>(axis)],
            axis == starts::Axis::phi ? angle_ticks(lo, hi) : even_ticks(lo, hi, wanted)};
}

std::string fixed_quantities(const starts::Certificate& certificate) {
    if (certificate.incoming) {
        return fmt::format("q = {}: all trajectories as they come in, evenly by the natural measure",
                           exact_text(certificate.box.lo[4]));
    }
    std::string text;
    for (std::size_t axis = 0; axis < starts::axis_count; ++axis) {
        if (!has_width(certificate.box, axis)) {
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", starts::axis_names[axis],
                                signed_text(certificate.box.lo[axis]));
        }
    }
    return text;
}

}  // namespace dumbbell::pictures
