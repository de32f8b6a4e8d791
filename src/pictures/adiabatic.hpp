#pragma once

#include <string>

#include "adiabatic/certificate.hpp"

namespace dumbbell::pictures {

/// The attained orbit of a certificate about the adiabatic invariant, enclosed again, collision by collision,
/// as a self-contained SVG: |phidot| and f = pi - arccos y next to I = |phidot| f, and the change of I next
/// to the bound that is proved for all orbits, which is told in words where it lies far outside. Throws
/// InputError for a claim about single bounces, for an orbit of so few collisions that there is no curve or
/// beyond most_plotted_bounces, and if double precision does not enclose it.
[[nodiscard]] std::string adiabatic_svg(const adiabatic::Certificate& certificate);

inline constexpr long most_plotted_bounces = 20'000;

}  // namespace dumbbell::pictures
