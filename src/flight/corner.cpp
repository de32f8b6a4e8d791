#include "flight/corner.hpp"

#include "base/error.hpp"

namespace dumbbell::flight {

long corner_count(const Rational& rho, const Rational& q, long most) {
    require(rho > 0 && q > 0 && most >= 1, "corner count: 0 < rho, 0 < Q, 1 <= most");
    // The powers a + i b sqrt Q of a number with the corner's argument, times whole numbers: b > 0 as long as
    // the multiple of the corner is less than pi.
    const Integer sum = numerator(rho) + denominator(rho);
    const Integer real = numerator(q) * numerator(rho) - denominator(q) * denominator(rho);
    Integer a = real, b = denominator(q) * sum;
    for (long n = 1; n <= most; ++n) {
        if (b <= 0) {
            return n;
        }
        const Integer next = real * a - numerator(q) * sum * b;
        b = denominator(q) * sum * a + real * b;
        a = next;
    }
    return most + 1;
}

}  // namespace dumbbell::flight
