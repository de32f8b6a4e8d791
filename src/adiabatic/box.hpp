#pragma once

#include <array>

#include "adiabatic/certificate.hpp"
#include "adiabatic/masses.hpp"

namespace dumbbell::adiabatic {

/// A box of a tree of an adiabatic certificate; its coordinates are exact. That of delta is its share t of
/// the way from D1 to D2. Axes that the tree lacks have width 0.
struct AdiabaticBox {
    std::array<double, adiabatic_axes> lo{};
    std::array<double, adiabatic_axes> hi{};

    [[nodiscard]] double width(AdiabaticAxis axis) const { return end(hi, axis) - end(lo, axis); }
    [[nodiscard]] double middle(AdiabaticAxis axis) const { return end(lo, axis) / 2 + end(hi, axis) / 2; }
    /// The slice at that middle.
    [[nodiscard]] AdiabaticBox collapsed(AdiabaticAxis axis) const {
        AdiabaticBox slice = *this;
        const auto i = static_cast<std::size_t>(axis);
        slice.lo[i] = slice.hi[i] = middle(axis);
        return slice;
    }
    [[nodiscard]] std::pair<AdiabaticBox, AdiabaticBox> halves(AdiabaticAxis axis) const {
        std::pair<AdiabaticBox, AdiabaticBox> result{*this, *this};
        const auto i = static_cast<std::size_t>(axis);
        result.first.hi[i] = result.second.lo[i] = middle(axis);
        return result;
    }
    [[nodiscard]] AdiabaticBox centre() const {
        AdiabaticBox point = *this;
        for (std::size_t i = 0; i < adiabatic_axes; ++i) {
            point.lo[i] = point.hi[i] = lo[i] / 2 + hi[i] / 2;
        }
        return point;
    }

  private:
    static double end(const std::array<double, adiabatic_axes>& ends, AdiabaticAxis axis) {
        return ends[static_cast<std::size_t>(axis)];
    }
};

/// The sides of boxes as the certificate's rules are tried with them: a little wider than they are, so that
/// another implementation has slack (format-adiabatic.md, section 2), but not beyond the root box.
class AdiabaticSides {
  public:
    explicit AdiabaticSides(const AdiabaticHypotheses& of);

    /// Of the tree with these axes.
    [[nodiscard]] AdiabaticBox root(std::initializer_list<AdiabaticAxis> axes) const;

    [[nodiscard]] Interval side(const AdiabaticBox& box, AdiabaticAxis axis) const;
    [[nodiscard]] AdiabaticMasses<Interval> masses(const AdiabaticBox& box) const;
    /// The least angle from the vertical that the hypotheses allow.
    [[nodiscard]] Interval margin(const AdiabaticMasses<Interval>& masses) const;
    [[nodiscard]] const AdiabaticHypotheses& hypotheses() const { return of_; }

    /// Whether all heights y = beta2 cos u are certainly outside the claim's.
    [[nodiscard]] bool certainly_elsewhere(const Interval& u, const AdiabaticMasses<Interval>& masses) const;
    /// Whether all of them certainly are the claim's; a scattering has no condition on them.
    [[nodiscard]] bool certainly_of_height(const Interval& u, const AdiabaticMasses<Interval>& masses) const;

  private:
    AdiabaticHypotheses of_;
    Interval margin_, lowest_, highest_;
};

}  // namespace dumbbell::adiabatic
