#pragma once

#include <optional>

#include "starts/cover/certificate.hpp"
#include "starts/given/angle.hpp"
#include "starts/walls/obstacle.hpp"

namespace dumbbell::starts {

/// What all starts of a box have. Enclosures do not decide it at any precision, but exact arithmetic does: a
/// flat fall, a corner before either mass has touched the floor, or a mass that grazes it in each turn, and
/// nothing collides.
struct ExactEvent {
    Obstacle kind;                   ///< flat, corner or graze
    std::optional<Rational> time{};  ///< of a corner of a single start
};

/// Corners and grazing contacts in the first flight of a box of starts, `phi` being the angle itself if it is
/// one and irrational.
///
/// *Corner.* Both masses are at height 0 iff y + ydot T = 0 and sin(phi + phidot T) = 0. T = -y/ydot is
/// rational, and phi = a + b pi with rational a, b, so that phi + phidot T is a multiple of pi iff b is an
/// integer and a + phidot T = 0 (pi is irrational). If phidot = 0, the rod is level all the way, so that this
/// holds for every y, ydot < 0 and mass ratio: a flat fall. Else only a point with b = 0 is looked at, and
/// whether a mass has touched before: at the time T - s, s > 0, the heights are |ydot| s +- beta sin(phidot
/// s) with the mass's beta, positive if |ydot| >= beta |phidot|; both are if that holds for beta2 = q/(1+q),
/// the greater one. Of a rod that turns by no more than pi only the mass that is the lower one all the way
/// needs it: the heavy one, beta1 = 1/(1+q), if phi > 0. (Nothing is said of a rod that turns by more than 3
/// radians if that is not certain.)
///
/// *Graze.* If ydot = 0 and y = beta2, the centre of mass keeps the height at which the light mass touches
/// the floor with the rod upright, and moves along it there; the heavy mass is never below 0, as beta1 <=
/// beta2. So there are no collisions.
///
/// Precondition: require_in_play(box).
[[nodiscard]] std::optional<ExactEvent> exact_event(const Box& box,
                                                    const std::optional<Angle>& phi = std::nullopt);

}  // namespace dumbbell::starts
