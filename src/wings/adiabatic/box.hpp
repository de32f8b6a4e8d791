#pragma once

#include <array>

#include "adiabatic/certificate.hpp"
#include "adiabatic/masses.hpp"

namespace dumbbell::adiabatic {

/// A box of a tree of an adiabatic certificate; its coordinates are exact. That of delta is its share t of
/// the way from D1 to D2. Axes that the tree lacks have width 0.
struct Box {
    std::array<double, axis_count> lo{};
    std::array<double, axis_count> hi{};

    [[nodiscard]] double width(Axis axis) const { return end(hi, axis) - end(lo, axis); }
    [[nodiscard]] double middle(Axis axis) const { return end(lo, axis) / 2 + end(hi, axis) / 2; }
    /// The slice at that middle.
    [[nodiscard]] Box collapsed(Axis axis) const {
        Box slice = *this;
        const auto i = static_cast<std::size_t>(axis);
        slice.lo[i] = slice.hi[i] = middle(axis);
        return slice;
    }
    [[nodiscard]] std::pair<Box, Box> halves(Axis axis) const {
        std::pair<Box, Box> result{*this, *this};
        const auto i = static_cast<std::size_t>(axis);
        result.first.hi[i] = result.second.lo[i] = middle(axis);
        return result;
    }
    [[nodiscard]] Box centre() const {
        Box point = *this;
        for (std::size_t i = 0; i < axis_count; ++i) {
            point.lo[i] = point.hi[i] = lo[i] / 2 + hi[i] / 2;
        }
        return point;
    }

  private:
    static double end(const std::array<double, axis_count>& ends, Axis axis) {
        return ends[static_cast<std::size_t>(axis)];
    }
};

/// The sides of boxes as the certificate's rules are tried with them: a little wider than they are, so that
/// another implementation has slack (format-adiabatic.md, section 2), but not beyond the root box.
class Sides {
  public:
    explicit Sides(const Hypotheses& of);

    /// Of the tree with these axes.
    [[nodiscard]] Box root(std::initializer_list<Axis> axes) const;

    [[nodiscard]] Interval side(const Box& box, Axis axis) const;
    [[nodiscard]] Masses<Interval> masses(const Box& box) const;
    /// The least angle from the vertical that the hypotheses allow.
    [[nodiscard]] Interval margin(const Masses<Interval>& masses) const;

    /// Whether all heights y = beta2 cos u are certainly outside the claim's.
    [[nodiscard]] bool certainly_elsewhere(const Interval& u, const Masses<Interval>& masses) const;
    /// Whether all of them certainly are the claim's; a scattering has no condition on them.
    [[nodiscard]] bool certainly_of_height(const Interval& u, const Masses<Interval>& masses) const;

  private:
    Hypotheses of_;
    Interval margin_, lowest_, highest_;
};

}  // namespace dumbbell::adiabatic
