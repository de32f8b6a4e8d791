#include "law/at_ratio.hpp"

#include <algorithm>

#include "law/certificate.hpp"
#include "law/constants.hpp"

namespace dumbbell::law {
namespace {

BigInterval number(const Rational& x) { return enclose<BigInterval>(x); }
BigInterval number(long p, long q) { return number(Rational(Integer(p), Integer(q))); }

/// delta_n by c0 and the root of q_c(n), enclosed.
BigInterval delta_bounds(const Integer& n, const Constants& constants) {
    if (n < 9) {
        return hull(number(-115, 1000), number(20, 1000));
    }
    // 0 < delta_n < 0.0200 for all n >= 9, so this has the root of q_c(n).
    const BigInterval root = (number(Rational(n - 2)) + hull(BigInterval(0), number(1, 50))) / constants.C;
    const BigInterval most = constants.c0 / sqrt(root);
    if (n <= last_step) {
        return hull(BigInterval(0), high_end(most));
    }
    const BigInterval log_term = number(63, 1000) * (log(root) + log(root)) + number(7, 10);
    return hull(low_end(most - log_term / root), high_end(most - number(16, 100) / root));
}

/// The integer nearest to about the middle of x.
Integer nearest(const BigInterval& x) {
    const Rational twice = exact_lo(x) + exact_hi(x) + 1;
    return numerator(twice) / (denominator(twice) * 2);
}

}  // namespace

BigInterval delta_bounds(const Integer& n) { return delta_bounds(n, Constants()); }

AtRatio law_at(const Rational& q) {
    // The law leaves open about q^(-1/2) of a step, of which there are q^(1/2).
    const auto size = static_cast<int>(msb(numerator(q))) - static_cast<int>(msb(denominator(q)));
    const PrecisionScope scope(std::max(0, size) + 128);
    const Constants constants;
    const BigInterval place = constants.C * sqrt(number(q));
    const Integer m = nearest(place);
    AtRatio result{q, m + 2, m + 1, m + 2, {}};
    // |C sqrt q - m| is a half and no more than rounding adds, and delta < 0.1: so q lies between the steps
    // to n - 1 and to n + 1, and it is n - 1 or n, by the side of the step to n.
    result.past = place - number(Rational(m)) - delta_bounds(result.step, constants);
    if (q == 1) {
        result.past = BigInterval(0);  // q_c(3) = 1: the maximum is 2 there, by the certificate's first step
    }
    if (certainly_positive(result.past)) {
        result.lower = result.upper;
    } else if (certainly_at_most(result.past, BigInterval(0))) {
        result.upper = result.lower;
    }
    return result;
}

}  // namespace dumbbell::law
