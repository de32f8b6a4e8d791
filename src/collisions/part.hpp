#pragma once

#include "collisions/certificate.hpp"
#include "number/part.hpp"

namespace dumbbell::collisions {

struct RatioPart {
    Part part;
    Rational whole_lo, whole_hi;
    Rational q_lo, q_hi;
};

/// Parts that cost about as much to prove, cut in the middle between steps. Should a cut lie in the gap at a
/// step, that part only takes longer. It depends on the arguments alone, on every machine. Precondition: 1 <=
/// q_lo < q_hi. Throws InputError if a part would have less than one step.
[[nodiscard]] RatioPart part_of(const Part& part, Scene scene, const Rational& q_lo, const Rational& q_hi);

}  // namespace dumbbell::collisions
