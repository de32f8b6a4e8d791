#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collisions/certificate.hpp"
#include "number/rational.hpp"

/// The leaf boxes of a certificate's tree as exact rationals, derived from format.md and
/// format-sections.md alone, for the page and the audit: nothing here is shared with chart.hpp but the words.
namespace dumbbell::collisions {

/// A closed box: for each Axis, where Boxes::values has its ends. Boxes of one tree share their ends, so a
/// tree of n leaves has about n numbers, not 6 n.
struct BoxEnds {
    std::array<std::uint32_t, axis_count> lo{};
    std::array<std::uint32_t, axis_count> hi{};
};

/// A root box and boxes that should tile it, in the order of the file.
struct Boxes {
    std::array<std::vector<Rational>, axis_count> values;
    BoxEnds root;
    std::vector<BoxEnds> leaves;

    [[nodiscard]] const Rational& lo(const BoxEnds& box, std::size_t axis) const {
        return values[axis][box.lo[axis]];
    }
    [[nodiscard]] const Rational& hi(const BoxEnds& box, std::size_t axis) const {
        return values[axis][box.hi[axis]];
    }

    /// The box [lo, hi]; its ends are added to `values`.
    [[nodiscard]] BoxEnds box(const std::array<Rational, axis_count>& lo,
                              const std::array<Rational, axis_count>& hi);
};

/// The root box of the chart over the mass ratios [q_lo, q_hi], without leaves.
[[nodiscard]] Boxes root_of(Chart chart, const Rational& q_lo, const Rational& q_hi);

/// The root box and the box of every leaf of the tree. A tree that ends early gives the leaves it has.
/// Throws InputError if nodes follow its end, or if an axis is split more than 400 times above a node
/// (format.md).
[[nodiscard]] Boxes leaf_boxes(Chart chart, const Rational& q_lo, const Rational& q_hi, const Tree& tree);

}  // namespace dumbbell::collisions
