#include "adiabatic/box.hpp"

#include "number/elementary.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr std::array<double, adiabatic_axes> root_ends{2, 8, 1, 2, 1};
constexpr double relative_pad = 0x1p-16;
constexpr double absolute_pad = 0x1p-40;

Interval wider(const Interval& side, double least, double greatest) {
    const Interval pad = (high_end(side) - low_end(side)) * Interval(relative_pad) + Interval(absolute_pad);
    return min(max(side + hull(-pad, pad), Interval(least)), Interval(greatest));
}

}  // namespace

AdiabaticSides::AdiabaticSides(const AdiabaticHypotheses& of)
    : of_(of),
      margin_(enclose<Interval>(of.margin)),
      lowest_(enclose<Interval>(of.heights.first)),
      highest_(enclose<Interval>(of.heights.second)) {}

AdiabaticBox AdiabaticSides::root(std::initializer_list<AdiabaticAxis> axes) const {
    AdiabaticBox box;
    for (const AdiabaticAxis axis : axes) {
        const auto i = static_cast<std::size_t>(axis);
        box.hi[i] = root_ends[i];
    }
    if (of_.delta.first == of_.delta.second) {
        box.hi[static_cast<std::size_t>(AdiabaticAxis::delta)] = 0;
    }
    return box;
}

Interval AdiabaticSides::side(const AdiabaticBox& box, AdiabaticAxis axis) const {
    const auto i = static_cast<std::size_t>(axis);
    return wider(Interval(box.lo[i], box.hi[i]), 0, root_ends[i]);
}

AdiabaticMasses<Interval> AdiabaticSides::masses(const AdiabaticBox& box) const {
    constexpr auto i = static_cast<std::size_t>(AdiabaticAxis::delta);
    const auto& [lo, hi] = of_.delta;
    const auto at = [first = lo, span = hi - lo](double share) {
        return enclose<Interval>(first + span * exact(share));
    };
    return AdiabaticMasses<Interval>(wider(hull(at(box.lo[i]), at(box.hi[i])), 0, 0.75));
}

Interval AdiabaticSides::margin(const AdiabaticMasses<Interval>& masses) const {
    switch (of_.claim) {
        case AdiabaticClaim::bounce:
            return margin_ * delta_power(masses.delta, of_.exponent);
        case AdiabaticClaim::run:
            return margin_;
        default:
            return margin_ * sqrt(masses.delta);
    }
}

bool AdiabaticSides::certainly_elsewhere(const Interval& u, const AdiabaticMasses<Interval>& masses) const {
    const Interval y = masses.beta2 * cos(u);
    return certainly_less(y, lowest_) || certainly_less(highest_, y);
}

bool AdiabaticSides::certainly_of_height(const Interval& u, const AdiabaticMasses<Interval>& masses) const {
    if (of_.claim == AdiabaticClaim::scattering) {
        return true;
    }
    const Interval y = masses.beta2 * cos(u);
    return certainly_at_most(lowest_, y) && certainly_at_most(y, highest_);
}

}  // namespace dumbbell::adiabatic
