#pragma once

#include "starts/cover/certificate.hpp"

/// All incoming trajectories of a mass ratio, by the natural measure (lemma L61): uniform in the angle phi
/// and in s in (-1, 1), the sine of the direction of flight against the vertical in the metric of the kinetic
/// energy, where they come down through a height above the floor curve. By the mirror s in [0, 1] is enough.
namespace dumbbell::starts {

/// The box of all of them in the coordinates of a certificate about them (format-initial.md, section 8): on
/// the axis phi the angle in units of pi, 0 to 2; on the axis phidot s, 0 to 1; y and ydot those of
/// yhat = 1 + 2^-20 and yhatdot = -1, for only the direction of a flight matters. Of a body with rho q is Q.
[[nodiscard]] Box incoming_box(const Rational& q, const std::optional<Rational>& rho = std::nullopt);

/// Whether the box reaches s = 1, where phidot has no end.
[[nodiscard]] bool is_unbounded(const Box& piece);

/// A box of initial conditions that contains the states of a piece of that box: phi up to bounds of pi, and
/// phidot = s sqrt(q/(1 - s^2)), which grows with s. Precondition: not is_unbounded.
[[nodiscard]] Box states_of_incoming(const Box& piece);

}  // namespace dumbbell::starts
