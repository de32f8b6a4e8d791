#pragma once

#include <array>
#include <string>
#include <vector>

#include "pictures/frame.hpp"
#include "pictures/plane_box.hpp"
#include "starts/cover/certificate.hpp"

/// A certificate about initial conditions that vary in two quantities, as a picture has them.
namespace dumbbell::pictures {

/// A leaf in units of the certificate's box: the root is [0, 1] x [0, 1].
struct StartCell {
    PlaneBox box;
    starts::Leaf leaf;

    /// Is the number of collisions the same for all its initial conditions?
    [[nodiscard]] bool is_exact() const { return leaf.most == leaf.least; }
    [[nodiscard]] Rational area() const { return (box.hi[0] - box.lo[0]) * (box.hi[1] - box.lo[1]); }
};

struct StartPlane {
    std::array<starts::Axis, 2> axes;  ///< horizontal, vertical
    std::vector<StartCell> cells;      ///< they tile the unit square, in the order of the file
};

/// Throws InputError unless exactly two of the five quantities are intervals.
[[nodiscard]] StartPlane start_plane(const starts::Certificate& certificate);

/// The picture's axis of a quantity, named as in format-initial.md.
[[nodiscard]] PlotAxis plot_axis(const starts::Certificate& certificate, starts::Axis axis);

/// What the other quantities are: `phidot = 1, y = 2, q = 10`.
[[nodiscard]] std::string fixed_quantities(const starts::Certificate& certificate);

/// What is said of the hatched part of such a picture.
inline constexpr const char* hatched_note = "Hatched: not decided by this certificate.";

}  // namespace dumbbell::pictures
