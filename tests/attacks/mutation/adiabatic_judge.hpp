// What the prover's formulas say of one box, or of one orbit, of a certificate about the adiabatic invariant.
#pragma once
#include <array>

#include "adiabatic/box.hpp"
#include "adiabatic/potential.hpp"

namespace dumbbell_mutation {

/// Of the tree of a class or of the claim; axes that the tree lacks have width 0.
struct AdiabaticSet {
    std::array<dumbbell::Rational, dumbbell::adiabatic::axis_count> lo{}, hi{};

    [[nodiscard]] std::pair<AdiabaticSet, AdiabaticSet> halves(dumbbell::adiabatic::Axis axis) const {
        std::pair<AdiabaticSet, AdiabaticSet> result{*this, *this};
        const auto i = static_cast<std::size_t>(axis);
        result.first.hi[i] = result.second.lo[i] = (lo[i] + hi[i]) / 2;
        return result;
    }
};

/// The axes of the trees of classes, and of the tree of the claim.
[[nodiscard]] std::vector<dumbbell::adiabatic::Axis> class_axes();
[[nodiscard]] std::vector<dumbbell::adiabatic::Axis> claim_axes(dumbbell::adiabatic::Claim claim);

class AdiabaticJudge {
  public:
    enum class Found { nothing, bound, outside };

    /// The certificate outlives the judge. Precondition: 0 <= D1 <= D2 < 1, and each class has cells, which
    /// go down.
    explicit AdiabaticJudge(const dumbbell::adiabatic::Certificate& certificate);

    [[nodiscard]] AdiabaticSet root(const std::vector<dumbbell::adiabatic::Axis>& axes) const;
    /// (D) of L35 for the flights of the box.
    [[nodiscard]] Found of_class(std::size_t number, const AdiabaticSet& box) const;
    /// The claimed bound for the states of the box, in a run or scattering by this class.
    [[nodiscard]] Found of_claim(std::size_t number, const AdiabaticSet& box) const;
    /// Whether the orbit in this place certainly satisfies the hypotheses and attains its value.
    [[nodiscard]] bool attained(std::size_t number) const;

  private:
    [[nodiscard]] Found of_bounce(const AdiabaticSet& box) const;
    [[nodiscard]] Found of_pair(std::size_t number, const AdiabaticSet& box) const;

    const dumbbell::adiabatic::Certificate& certificate_;
    dumbbell::adiabatic::Sides sides_;
    std::vector<dumbbell::adiabatic::Potential<dumbbell::Interval>> potentials_;  ///< of the classes
};

}  // namespace dumbbell_mutation
