#include "law/at_ratio.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "law/constants.hpp"

namespace dumbbell::law {
namespace {

BigInterval number(const Rational& x) { return enclose<BigInterval>(x); }
BigInterval number(long p, long q) { return number(Rational(Integer(p), Integer(q))); }

/// Bounds of delta_n = C sqrt(q_c(n)) - (n - 2) by Theorem A of proofs/law.md. Precondition: n > last_step.
BigInterval delta_bounds(const Integer& n, const Constants& constants) {
    require(n > Integer(last_step), "Theorem A is about the steps beyond those of the certificate");
    // 0 < delta_n < 0.0200, so this has the root of q_c(n).
    const BigInterval root = (number(Rational(n - 2)) + hull(BigInterval(0), number(1, 50))) / constants.C;
    const BigInterval s = sqrt(BigInterval(1) / root), log_q = log(root) + log(root);
    const BigInterval after = number(n % 2 == 0 ? 497 : 380, 1000);
    const BigInterval slack = number(72, 1000) + number(26, 10) * s;
    return constants.c0 * s - (constants.kappa * log_q + after + hull(-slack, slack)) / root;
}

/// The integer nearest to about the middle of x.
Integer nearest(const BigInterval& x) {
    const Rational twice = exact_lo(x) + exact_hi(x) + 1;
    return numerator(twice) / (denominator(twice) * 2);
}

/// By Theorem A: n > last_step, and place encloses C sqrt q.
void decide_by_theorem(AtRatio& at, const BigInterval& place, const Constants& constants) {
    at.past = place - number(Rational(at.step - 2)) - delta_bounds(at.step, constants);
    if (certainly_positive(at.past)) {
        at.lower = at.upper;
    } else if (certainly_at_most(at.past, BigInterval(0))) {
        at.upper = at.lower;
    }
}

/// By the ratios at which the certificate proves n - 1 and n. That q_c(3) = 1 is Theorem 2 (d).
void decide_by_step(AtRatio& at, const BigInterval& place, const StepEnds& ends, const Constants& constants) {
    const bool first = at.step == Integer(first_step);
    const Rational& above = first ? ends.below : ends.above;
    at.past = place - constants.C * hull(sqrt(number(ends.below)), sqrt(number(above)));
    const BigInterval zero(0);
    if (at.q <= ends.below) {
        at.upper = at.lower;
        at.past = at.q == above ? zero : min(at.past, zero);
    } else if (first || at.q >= above) {
        at.lower = at.upper;
        at.past = max(at.past, zero);
    }
}

}  // namespace

AtRatio law_at(const Rational& q, const std::vector<StepEnds>& steps) {
    require(std::ssize(steps) == last_step - first_step + 1, "the law: a step is missing");
    // The law leaves open about q^(-1/2) of a step, of which there are q^(1/2).
    const auto size = static_cast<int>(msb(numerator(q))) - static_cast<int>(msb(denominator(q)));
    const PrecisionScope scope(std::max(0, size) + 128);
    const Constants constants;
    const BigInterval place = constants.C * sqrt(number(q));
    const Integer m = nearest(place);
    AtRatio result{q, m + 2, m + 1, m + 2, {}};
    // |C sqrt q - m| is a half and no more than rounding adds, and |delta| < 0.12: so q lies between the
    // steps to n - 1 and to n + 1, and N(q) is n - 1 or n, by the side of the step to n.
    if (result.step > Integer(last_step)) {
        decide_by_theorem(result, place, constants);
    } else {
        const auto i = static_cast<std::size_t>(result.step.convert_to<long>() - first_step);
        decide_by_step(result, place, steps[i], constants);
    }
    return result;
}

BigInterval critical_ratio(const Integer& n) {
    require(n > Integer(last_step), "the law encloses critical ratios beyond its steps only");
    const PrecisionScope scope(2 * static_cast<int>(msb(n)) + 128);
    const Constants constants;
    const BigInterval place = number(Rational(n - 2)) + delta_bounds(n, constants);
    return sqr(place / constants.C);
}

}  // namespace dumbbell::law
