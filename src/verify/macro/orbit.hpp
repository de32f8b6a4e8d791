// Polynomials that nearly follow an orbit over many collisions. Guesses: L42 takes any.
#pragma once
#include "verify/macro/check.hpp"

namespace dumbbell_verify {

/// False if no orbit was found.
[[nodiscard]] bool guess_orbit(const Start& start, Orbit& orbit);

}  // namespace dumbbell_verify
