#include "adiabatic/branch.hpp"

#include <algorithm>

#include "adiabatic/bounce_leaf.hpp"

namespace dumbbell::adiabatic {

double printed_branch_error(const AdiabaticState& state) {
    const auto in = [](const Rational& x) { return enclose<Interval>(x); };
    const AdiabaticBounce<Interval> bounce(in(state.u), in(state.s),
                                           AdiabaticMasses<Interval>(in(state.delta)));
    const Interval& beta2 = bounce.masses.beta2;
    const Interval error =
        Interval(4) * bounce.s / (beta2 * bounce.rho()) - bounce.speed_error() / bounce.masses.delta;
    return std::max(0.0, error.lo());
}

}  // namespace dumbbell::adiabatic
