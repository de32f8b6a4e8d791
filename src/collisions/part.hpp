#pragma once

#include "collisions/claim.hpp"
#include "number/part.hpp"

namespace dumbbell::collisions {

struct RatioPart {
    Part part;
    Range whole, range;
};

/// Parts that cost about as much to prove: cut in the middle between steps, or, where nothing is known of the
/// steps, of equal width. Should a cut lie in the gap at a step, that part only takes longer. It depends on
/// the arguments alone, on every machine. Precondition: a range, from 1 on. Throws InputError if a part would
/// have less than one step.
[[nodiscard]] RatioPart part_of(const Part& part, const Claim& claim);

}  // namespace dumbbell::collisions
