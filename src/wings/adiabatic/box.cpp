#include "adiabatic/box.hpp"

#include "number/elementary.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr std::array<double, axis_count> root_ends{2, 8, 1, 2, 1};
constexpr double relative_pad = 0x1p-16;
constexpr double absolute_pad = 0x1p-40;

Interval wider(const Interval& side, double least, double greatest) {
    const Interval pad = (high_end(side) - low_end(side)) * Interval(relative_pad) + Interval(absolute_pad);
    return min(max(side + hull(-pad, pad), Interval(least)), Interval(greatest));
}

}  // namespace

Sides::Sides(const Hypotheses& of)
    : of_(of),
      margin_(enclose<Interval>(of.margin)),
      lowest_(enclose<Interval>(of.heights.first)),
      highest_(enclose<Interval>(of.heights.second)) {}

Box Sides::root(std::initializer_list<Axis> axes) const {
    Box box;
    for (const Axis axis : axes) {
        const auto i = static_cast<std::size_t>(axis);
        box.hi[i] = root_ends[i];
    }
    if (of_.has_one_delta()) {
        box.hi[static_cast<std::size_t>(Axis::delta)] = 0;
    }
    return box;
}

Interval Sides::side(const Box& box, Axis axis) const {
    const auto i = static_cast<std::size_t>(axis);
    return wider(Interval(box.lo[i], box.hi[i]), 0, root_ends[i]);
}

Masses<Interval> Sides::masses(const Box& box) const {
    constexpr auto i = static_cast<std::size_t>(Axis::delta);
    const auto& [lo, hi] = of_.delta;
    const auto at = [first = lo, span = hi - lo](double share) {
        return enclose<Interval>(first + span * exact(share));
    };
    return Masses<Interval>(wider(hull(at(box.lo[i]), at(box.hi[i])), 0, 0.75));
}

Interval Sides::margin(const Masses<Interval>& masses) const {
    switch (of_.claim) {
        case Claim::bounce:
            return margin_ * delta_power(masses.delta, of_.exponent);
        case Claim::run:
            return margin_;
        default:
            return margin_ * sqrt(masses.delta);
    }
}

bool Sides::certainly_elsewhere(const Interval& u, const Masses<Interval>& masses) const {
    const Interval y = masses.beta2 * cos(u);
    return certainly_less(y, lowest_) || certainly_less(highest_, y);
}

bool Sides::certainly_of_height(const Interval& u, const Masses<Interval>& masses) const {
    if (of_.claim == Claim::scattering) {
        return true;
    }
    const Interval y = masses.beta2 * cos(u);
    return certainly_at_most(lowest_, y) && certainly_at_most(y, highest_);
}

}  // namespace dumbbell::adiabatic
