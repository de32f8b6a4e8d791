#pragma once

#include "number/big_interval.hpp"

namespace dumbbell::law {

/// An enclosure of c0 = 4 |zeta(-1/2)| / (3^(3/4) sqrt pi) (proofs/law.md), with the thread's working
/// precision; zeta by Arb.
[[nodiscard]] BigInterval correction_constant();

/// Those of the law and of Theorem 4, with the thread's working precision; kappa = 5/(36 sqrt3 pi) is the
/// coefficient of the logarithm in Theorem A.
struct Constants {
    BigInterval C, c0, kappa;

    Constants();
};

}  // namespace dumbbell::law
