#include "law/bulk_rule.hpp"

#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

constexpr int bulk_parts = 288;        ///< of the quadrature of P
constexpr int bulk_second_parts = 12;  ///< of that in the term of second order

/// int_a^b f(x) dx for the ends in these intervals, by n equal parts.
template <class Function>
Interval integral(const Function& f, const Interval& a, const Interval& b, int n) {
    Interval sum(0);
    for (int i = 0; i < n; ++i) {
        sum = sum + f(a + (b - a) * part(i, n));
    }
    return sum * (b - a) / n;
}

/// cos(Q/cos x)/cos x, of which -P is the integral.
Interval P_density(const Interval& Q, const Interval& x) {
    const Interval c = cos(x);
    return cos(Q / c) / c;
}

/// tau_JJ at fixed alpha.
Interval second_derivative_of_clock(const Interval& J, const Interval& alpha) {
    const Interval end = half_pi<Interval>() - asin(J / pi<Interval>());
    const Interval sum = integral(
        [&](const Interval& x) {
            const Interval c = cos(x);
            return sin(J / c) / sqr(c);
        },
        alpha, end, bulk_second_parts);
    return pi<Interval>() / (J * sqrt(sqr(pi<Interval>()) - sqr(J))) - sum;
}

/// W''(x), W(x) = sin(Q/cos x).
Interval W2(const Interval& Q, const Interval& x) {
    const SinCos<Interval> at = sin_cos(x);
    const Interval a = Q / at.cos, tangent = at.sin / at.cos;
    const SinCos<Interval> of_a = sin_cos(a);
    return of_a.cos * a * (sqr(tangent) + 1 / sqr(at.cos)) - of_a.sin * sqr(a * tangent);
}

Interval bulk_window() { return half_pi<Interval>() + hull(Interval(-1), Interval(3)) / 100'000; }

Interval cube(const Interval& x) { return x * sqr(x); }

}  // namespace

Interval P_at(const Interval& th) {
    const Interval Q = bulk_window();
    const Interval end = half_pi<Interval>() - asin(Q / pi<Interval>());
    return -integral([&](const Interval& x) { return P_density(Q, x); }, th, end, bulk_parts);
}

BulkBounds bulk_bounds(const Interval& th, const Interval& eps, const Interval& P) {
    const SinCos<Interval> of_th = sin_cos(th);
    const Interval &sin_th = of_th.sin, &cos_th = of_th.cos, tan_th = sin_th / cos_th;

    const Interval Q = bulk_window();
    const Interval F = Q / cos_th, U = pi<Interval>() - F;
    const SinCos<Interval> of_U = sin_cos(U);
    const Interval &sin_U = of_U.sin, &cos_U = of_U.cos;

    // sin d = eps t; d = eps de; asin x in x [1, 1 + x^2/6 (1 + x^2)] for x <= 1/2.
    const Interval t = tan_th * F / sin_U, sin_d = eps * t, x2 = sqr(sin_d);
    const Interval de = t * hull(Interval(1), 1 + x2 / 6 * (1 + x2));
    const Interval d = eps * de, d2 = sqr(d), cos_d = sqrt(1 - x2);
    // sin u and sin u', u = U + d, u' = U - d, and the kicks there.
    const Interval w = sin_U * cos_d + cos_U * sin_d, w2 = sin_U * cos_d - cos_U * sin_d;
    const Interval k = eps / w, k2 = eps / w2;
    const Interval c = 1 / sqrt(1 + sqr(k)), c2 = 1 / sqrt(1 + sqr(k2));
    const Interval sinc_2d = sinc(2 * d), sin_2U = 2 * (sin_U * cos_U);

    // (8) of proofs/law.md, each over its power of eps.
    const Interval dX =
        2 * (de * (sqr(t / sin_U) - 2 * (sqr(de) * at_most_one(d2 / 5)) / 3)) / (1 - sqr(sin_d / sin_U));
    const Interval X2 = -(sqr(de) * (sinc(d) * cos_U + sin_U * (d * at_most_one(d2 / 10) / 3)) / w2);
    const Interval dc = sqr(c) * sqr(c2) / (c + c2) * (2 * (de * sin_2U * sinc_2d)) / sqr(w * w2);
    const Interval ds = 2 * (de * sin_2U * sinc_2d * c * c2) / (w * w2 * (w / c + w2 / c2));
    const Interval dA = cos_th * (c * dX + sqr(eps) * X2 * dc) + Q * dc + sin_th * de * ds;
    const Interval A2 = cos_th * c2 * X2 - Q * sqr(c2) / (1 + c2) / sqr(w2) - sin_th * de * c2 / w2;
    const Interval A = A2 + eps * dA;

    // (14): int W - 2 eps, over eps^3. b = beta/eps.
    const Interval b = at_most_one(sqr(k) / 3) / w, b2 = at_most_one(sqr(k2) / 3) / w2, sum_b = b + b2;
    const Interval tangents =
        (cube(1 / w) * at_most_one(3 * sqr(k) / 5) + cube(1 / w2) * at_most_one(3 * sqr(k2) / 5)) / 3;
    const Interval one_less_cos = sqr(de) / 2 * at_most_one(d2 / 12);
    const Interval d_tan = 2 * (cos_U * t) / (w * w2);
    const Interval d_beta = d_tan * at_most_one(max(sqr(k), sqr(k2)));
    const Interval alpha = th - eps * b, alpha2 = th + eps * b2, between = hull(alpha, alpha2);
    const Interval excess = sin_U * (one_less_cos * (1 / w + 1 / w2) - tangents) + cos_U * t * d_tan -
                            cos_U * F * tan_th * d_beta * sum_b / 2 +
                            W2(Q, between) * (cube(b) + cube(b2)) / 6;

    const Interval density = P_density(Q, between), P2 = P + eps * b2 * density, dP = density * sum_b;
    const Interval reach = -(max(abs(A), abs(A2)) * sqr(eps));
    const Interval J = Q + hull(Interval(reach.lo()), Interval(0));
    const Interval second = second_derivative_of_clock(J, between);
    const Interval all = excess - P2 * dA + dP * A + eps / 2 * (second * sqr(A) - second * sqr(A2));
    return {all / sum_b, dA / sum_b};
}

}  // namespace dumbbell::law
