#pragma once

#include <vector>

#include "law/certificate.hpp"
#include "number/big_interval.hpp"
#include "number/rational.hpp"

namespace dumbbell::law {

/// What the law says of one mass ratio.
struct AtRatio {
    Rational q;
    Integer step;          ///< n whose step, at q_c(n), is the nearest one by C sqrt q
    Integer lower, upper;  ///< of N(q); n - 1 and n where it is open on which side of that step q lies
    /// C (sqrt q - sqrt q_c(n)), enclosed: how far q is past the step, as a share of the way to the next one,
    /// which is 1.
    BigInterval past;
};

/// With as many bits as q needs; by the steps of the law's certificate, and by Theorem A beyond them.
/// Precondition: q >= 1.
[[nodiscard]] AtRatio law_at(const Rational& q, const std::vector<StepEnds>& steps);

/// An enclosure of the critical ratio q_c(n) = ((n - 2 + delta_n)/C)^2 by Theorem A of proofs/law.md, with as
/// many bits as it has width: about ln q of the q_c(n) there are. Precondition: n > last_step.
[[nodiscard]] BigInterval critical_ratio(const Integer& n);

}  // namespace dumbbell::law
