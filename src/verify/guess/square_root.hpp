// Near the square root of a number, which is > 0.
#pragma once
#include "verify/core/big.hpp"

namespace dumbbell_verify {

inline double guess_square_root(double x) { return std::sqrt(x); }
inline Big guess_square_root(const Big& x) { return Big::rounded(down, mpfr_sqrt, x.get()); }

}  // namespace dumbbell_verify
