#pragma once

#include "adiabatic/search.hpp"

namespace dumbbell::adiabatic {

/// Scatterings that begin as far from the vertical as Theorem 3.5 asks, with |ydot| >= delta/2, and change I
/// by order 1: their last collision is so near the vertical that it takes almost all of |phidot| (L41). In
/// plain doubles; those with the greatest change first.
[[nodiscard]] std::vector<AdiabaticSample> search_printed(const AdiabaticSearch& search);

}  // namespace dumbbell::adiabatic
