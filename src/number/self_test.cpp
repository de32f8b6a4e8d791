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

/// Whether quotients are what IEEE 754 says where a compiler that thinks of numbers, and not of doubles,
/// makes products of them: with the reciprocal of a divisor that several share, or that it knows
/// (-freciprocal-math).
bool quotients_are_plain() {
    const double divisor = opaque(49.0), other = opaque(11.0);
    const double five = opaque(5.0) / divisor, nine = opaque(9.0) / divisor, ten = opaque(10.0) / divisor,
                 eleven = other / divisor, thirteen = opaque(13.0) / divisor;
    const double known = opaque(5.0) / 49.0, twice = opaque(1.0) / opaque(3.0) / other;
    return five == 0x1.a1f58d0fac688p-4 && nine == 0x1.7829cbc14e5e1p-3 && ten == 0x1.a1f58d0fac688p-3 &&
           eleven == 0x1.cbc14e5e0a72fp-3 && thirteen == 0x1.0fac687d6343fp-2 &&
           known == 0x1.a1f58d0fac688p-4 && twice == 0x1.f07c1f07c1f07p-6;
}

/// The same of sums, products and roots that look as if they could be had for less (-fassociative-math).
bool terms_are_plain() {
    const double tenth = opaque(0.1), root = std::sqrt(opaque(2.0));
    const double sum = tenth * opaque(0.3) + tenth * opaque(0.1), back = opaque(3.0) * tenth / tenth,
                 product = root * root, reciprocal = opaque(1.0) / root;
    return sum == 0x1.47ae147ae147bp-5 && back == 0x1.8000000000001p+1 && product == 0x1.0000000000001p+1 &&
           reciprocal == 0x1.6a09e667f3bccp-1;
}

/// Whether there are an infinity and a NaN, which a compiler may leave out of account (-ffinite-math-only).
bool has_all_values() {
    const double nan = opaque(std::numeric_limits<double>::quiet_NaN()),
                 great = opaque(std::numeric_limits<double>::max());
    return !(nan < 1) && !(nan >= 1) && nan != nan && great * 2 > great && !(great * 2 - great * 2 == 0);
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

    require(quotients_are_plain(), "self-test: quotients are not correctly rounded; refusing to compute");
    require(terms_are_plain(), "self-test: terms are regrouped; refusing to compute");
    require(has_all_values(), "self-test: there is no infinity, or no NaN; refusing to compute");

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
