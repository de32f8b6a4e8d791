// Macro steps (L42): a bound of a ray is moved over many collisions at once, by polynomials that it cannot
// cross.
#pragma once
#include "verify/core/number.hpp"

namespace dumbbell_verify {

/// A bound of a set of rays after a collision, on the side d: corner distance, slope of the flight that
/// follows, and mass ratio 1/r. All >= 0.
struct WallBound {
    mpq_class x, kappa, r;
};

/// Moves x and kappa over as many collisions as it finds that it can at a time, at most `most`, and returns
/// how many: 0 if none, or too few to be worth it. `down`: every ray of the set that collides so often has
/// then x, kappa at or above them; `up`: every ray collides so often, and has them at or below. `bits`: about
/// the precision that the bounds have.
[[nodiscard]] mpz_class macro_step(Round d, WallBound& bound, const mpz_class& most, long bits);

}  // namespace dumbbell_verify
