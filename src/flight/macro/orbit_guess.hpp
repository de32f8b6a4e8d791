#pragma once

#include <optional>

#include "flight/macro/check.hpp"

/// Polynomials that nearly follow an orbit over many collisions. Guesses: nothing is proved here, and L42
/// needs no more than that they are polynomials.
namespace dumbbell::flight::macro {

/// Nothing if it does not converge: fewer collisions may help.
[[nodiscard]] std::optional<Orbit> guess_orbit(const Task& task);

}  // namespace dumbbell::flight::macro
