// The self-test of the arithmetic.
#include <cfenv>
#include <cfloat>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {
namespace {

/// Whether no compiler made products of quotients that share a divisor, regrouped terms or fused them, where
/// the results are others: clang tells of no such flag (-freciprocal-math, -fassociative-math,
/// -ffp-contract).
bool terms_are_kept() {
    const volatile double five = 5, nine = 9, ten = 10, eleven = 11, tenth = 0.1, third = 0.3, by = 49,
                          above = 1 + 0x1p-27, below = 1 - 0x1p-27;
    const double divisor = by, x = tenth;
    const double a = five / divisor, b = nine / divisor, c = ten / divisor, d = eleven / divisor,
                 e = five / 49.0;
    const double sum = x * third + x * tenth, back = 3 * x / tenth, one = above * below;
    return a == 0x1.a1f58d0fac688p-4 && b == 0x1.7829cbc14e5e1p-3 && c == 0x1.a1f58d0fac688p-3 &&
           d == 0x1.cbc14e5e0a72fp-3 && e == a && sum == 0x1.47ae147ae147bp-5 &&
           back == 0x1.8000000000001p+1 && one - 1 == 0;
}

}  // namespace

/// Whether this thread rounds to nearest and keeps subnormal numbers.
bool arithmetic_works() {
    const volatile double one = 1, e = 0x1p-53, least = DBL_MIN;
    // A compiler that regroups sums (-fassociative-math) may lose what outward() adds.
    if (!(add(up, one, e) > one && add(down, -one, -e) < -one && terms_are_kept())) return false;
    // fegetround asks the x87 unit, which no bound uses, but libraries might.
    return std::fegetround() == FE_TONEAREST && one + e == one && one + 1.5 * e > one &&
           -one - 1.5 * e < -one && least / 4 * 4 == least;
}

}  // namespace dumbbell_verify
