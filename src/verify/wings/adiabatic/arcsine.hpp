// The arcsine by its series (format-adiabatic.md, section 3).
#pragma once
#include "verify/core/interval.hpp"
#include "verify/machine/meter.hpp"

namespace dumbbell_verify::adiabatic {

constexpr int most_arcsine_terms = 512;

/// Encloses asin(z)/z, 1 at z = 0, for all z of Z with |z| < 1: the sum of a_n z^(2n), a_0 = 1,
/// a_n/a_(n-1) = (2n - 1)^2/(2n (2n + 1)) < 1. No term is negative, so that each end comes from the end of
/// the squares alone, and those after the term t add up to at most t (z^2 + z^4 + ...) = t z^2/(1 - z^2).
/// Unbounded where Z reaches 1.
template <class N>
Interval<N> arcsine_share(const Interval<N>& Z) {
    using I = Interval<N>;
    const I y = square(Z);
    I term = 1, sum = 1;
    for (int n = 1; n <= most_arcsine_terms; ++n) {
        Meter::spend(1 << 7);
        term = term * y * (I((2 * n - 1) * (2 * n - 1)) / I(2 * n * (2 * n + 1)));
        sum = sum + term;
        if (add(down, sum.hi, term.hi) <= sum.hi) break;  // more terms do not show
    }
    return {sum.lo, (sum + term * y / (I(1) - y)).hi};
}

}  // namespace dumbbell_verify::adiabatic
