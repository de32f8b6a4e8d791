#pragma once

#include <limits>

#include "base/interrupted.hpp"
#include "flight/macro/when.hpp"
#include "number/big_interval.hpp"
#include "number/count.hpp"
#include "number/interval.hpp"

/// Macro steps (lemma L42): a bound of a ray is moved over many collisions at once.
namespace dumbbell::flight::macro {

enum class BoundSide { lower, upper };

/// A bound, from below or from above, of the states of a set of rays after a collision with a light wall: its
/// corner distance, and the slope of the flight that follows. Thin.
template <class I>
struct WallState {
    I x;
    I kappa;
};

/// Moves `state` over as many collisions as it can at a time, at most `most`, and returns how many: 0 if
/// none, or too few to be worth it, or if interrupted. If `state` bounds rays of mass ratio 1/r (thin, a
/// bound on the same side) after collision n, it then bounds them after collision n + result: from below,
/// those that collide so often; from above, all of them, and they do collide so often. Precondition: 0 < r, 0
/// <= x, 0 <= kappa. It works in multiple precision for bounds in double, too. Only the two types below have
/// macro steps.
template <class I>
[[nodiscard]] Count macro_step(BoundSide /*side*/, const I& /*r*/, WallState<I>& /*state*/,
                               const Count& /*most*/, const Interrupted& /*interrupted*/ = never) {
    return 0;
}
template <>
[[nodiscard]] Count macro_step(BoundSide side, const Interval& r, WallState<Interval>& state,
                               const Count& most, const Interrupted& interrupted);
template <>
[[nodiscard]] Count macro_step(BoundSide side, const BigInterval& r, WallState<BigInterval>& state,
                               const Count& most, const Interrupted& interrupted);

/// Rays that are followed for fewer collisions than this have no macro step worth trying, at the working
/// precision.
template <class I>
[[nodiscard]] long least_worth_a_macro_step() {
    return std::numeric_limits<long>::max();
}
template <>
[[nodiscard]] inline long least_worth_a_macro_step<Interval>() {
    return least_in_double;
}
template <>
[[nodiscard]] long least_worth_a_macro_step<BigInterval>();

/// Whether any state of rays of mass ratio 1/r has a macro step: in double a step is for 2000 collisions or
/// more, and at most a third of those that seem to be left, 0.71/sqrt(r).
template <class I>
[[nodiscard]] bool may_have_macro_steps(const I& /*r*/) {
    return true;
}
template <>
[[nodiscard]] inline bool may_have_macro_steps(const Interval& r) {
    return r.lo() < 0x1p-26;
}

}  // namespace dumbbell::flight::macro
