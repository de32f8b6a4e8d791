#pragma once

#include "number/big_interval.hpp"
#include "number/integer.hpp"

namespace dumbbell::law {

/// An enclosure of the critical ratio q_c(n) = ((n - 2 + delta_n)/C)^2 by Theorem A of proofs/law.md, with as
/// many bits as it has width: about ln q of the q_c(n) there are. Precondition: n > last_step.
[[nodiscard]] BigInterval critical_ratio(const Integer& n);

}  // namespace dumbbell::law
