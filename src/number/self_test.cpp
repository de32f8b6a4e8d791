#include "number/self_test.hpp"

#include <cfenv>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace dumbbell {
namespace {

/// Hides a value from the optimiser: the operation is then done at run time, in the thread's own mode.
double opaque(double x) {
    volatile double hidden = x;
    return hidden;
}

}  // namespace

void require_sound_arithmetic() {
    require(std::fegetround() == FE_TONEAREST,
            "self-test: this thread does not round to nearest; refusing to compute");

    const double one = opaque(1.0);
    const double half_ulp = opaque(0x1p-53);
    // Ties to even: both sums are exactly half way between two doubles.
    require(one + half_ulp == 1.0 && (one + opaque(0x1p-52)) + half_ulp == 1.0 + 0x1p-51,
            "self-test: addition does not round to nearest even; refusing to compute");
    require(-one - half_ulp == -1.0,
            "self-test: subtraction does not round to nearest even; refusing to compute");

    // A compiler that regroups sums (-fassociative-math) finds 2^-60 here.
    require((opaque(0x1p-60) + one) - one == 0, "self-test: sums are regrouped; refusing to compute");

    const double least = opaque(std::numeric_limits<double>::min());
    require(least / 2 > 0 && opaque(std::numeric_limits<double>::denorm_min()) * 1.0 > 0,
            "self-test: subnormal numbers are flushed to zero; refusing to compute");

    // A compiler for which -0 is 0 (-fno-signed-zeros) leaves out the sum that makes a -0 a 0 (L62).
    const double vanished = opaque(-0x1p-600) * opaque(0x1p-600);
    require(std::signbit(vanished) && !std::signbit(vanished + 0.0),
            "self-test: the sign of zero is lost; refusing to compute");

    // (1 + 2^-27)(1 - 2^-27) = 1 - 2^-54 rounds to 1 (tie to even); a fused or extended evaluation keeps the
    // difference.
    const double product = opaque(1 + 0x1p-27) * opaque(1 - 0x1p-27);
    require(product - 1 == 0, "self-test: products are not rounded to double; refusing to compute");
    require(opaque(1.0) / opaque(3.0) == 0x1.5555555555555p-2,
            "self-test: division is not correctly rounded");
    require(std::sqrt(opaque(2.0)) == 0x1.6a09e667f3bcdp+0, "self-test: sqrt is not correctly rounded");
}

}  // namespace dumbbell
