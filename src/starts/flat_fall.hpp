#pragma once

#include <optional>

#include "starts/certificate.hpp"

namespace dumbbell::starts {

/// The time at which both masses of this one initial condition reach the floor at once, before either has
/// touched it: a corner, after which no motion is defined and no precision decides anything. Nothing if the
/// box is no point; nor, for a rod that turns by more than 3 radians on its way down, if that is not certain.
///
/// Both masses are at height 0 iff y + ydot T = 0 and sin(phi + phidot T) = 0. T = -y/ydot is rational, and
/// of the rationals only 0 has the sine 0 (pi is irrational): the condition is phi ydot = phidot y. At the
/// time T - s, s > 0, the heights then are |ydot| s +- beta sin(phidot s) with the mass's beta, positive if
/// |ydot| >= beta |phidot|; both are if that holds for beta2 = q/(1+q), the greater one. Of a rod that turns
/// by no more than pi only the mass that is the lower one all the way needs it: the heavy one, beta1 =
/// 1/(1+q), if phi > 0. Precondition: require_in_play(box).
[[nodiscard]] std::optional<Rational> flat_fall(const InitialBox& box);

}  // namespace dumbbell::starts
