#pragma once

#include "number/big_interval.hpp"

namespace dumbbell::flight {

/// An enclosure of C = integral of sin((pi/2) / cos theta) for theta from 0 to pi/3, the limit of N(q) /
/// sqrt q (theorem 4 of proofs/theorem.md), by verified quadrature (Arb) with the thread's working precision;
/// wider than that precision by a few bits.
[[nodiscard]] BigInterval growth_constant();

}  // namespace dumbbell::flight
