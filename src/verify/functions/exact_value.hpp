// The rational number that a number is.
#pragma once
#include "verify/core/big.hpp"

namespace dumbbell_verify {

inline mpq_class exact_value(double x) { return mpq_class(x); }
inline mpq_class exact_value(const Big& a) {
    mpq_class result;
    mpfr_get_q(result.get_mpq_t(), a.get());
    return result;
}

}  // namespace dumbbell_verify
