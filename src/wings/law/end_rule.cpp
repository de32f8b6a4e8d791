#include "law/end_rule.hpp"

#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

constexpr int end_second_parts = 16;  ///< of the quadrature in the term of second order
constexpr int end_passes = 5;         ///< of the iteration that encloses Q

/// The quantities of the last flight; (10) and (15) of proofs/law.md. kappa = d^2 kh, eps = d^2 epsh, A = d
/// ah, and rk = d^4 kh^2/2 [1, 1 + kappa^2].
struct Last {
    Slope F, Q, kh, epsh, ah;
    Interval one;  ///< [1, 1 + kappa^2]
};

Last last(const Interval& d, const Slope& Q) {
    const Slope x = line(d, Interval(0), Interval(1));
    const Slope sinc_d = sinc_of(Interval(1), d), sinc_2d = sinc_of(Interval(2), d);
    const Slope F = line(d, pi<Interval>(), Interval(-1));
    const Slope cos_th = Q / F, sin_th = sqrt(1 - sqr(cos_th));
    const Interval d2 = sqr(d);

    // kh = (sinc^2 d + d^2 kh^2/4 [1, 1 + kappa^2])/F, from a window that holds by L53 (c).
    Interval k(0, 0.5), one(1);
    for (int i = 0; i < end_passes; ++i) {
        one = hull(Interval(1), 1 + sqr(k * d2));
        k = common((sqr(sinc(d)) + d2 * sqr(k) / 4 * one) / range(F), k);
    }
    const Slope rh = squared(d, sqr(k) / 2 * one);  // rk/d^2
    const Slope kh = (sqr(sinc_d) + rh / 2) / F, epsh = kh * (cos_th / sin_th);

    const Slope b = epsh / (2 * sinc_2d), tan_beta = x * b, c = 1 / sqrt(1 + sqr(tan_beta));
    const Slope ah = c * cos_th * (sinc_d / (2 * cos_of(d)) + rh / (4 * sinc_2d) - 1) -
                     Q * x * sqr(b) * sqr(c) / (1 + c) - x * sin_th * b * c;
    return {F, Q, kh, epsh, ah, one};
}

/// For Q = pi/2 + d q.
Last last(const Interval& d, const Interval& q) { return last(d, line(d, half_pi<Interval>(), q)); }

/// That q, from Q = J - A and the window of J.
Interval narrowed(const Interval& d, const Interval& q) {
    const Last at = last(d, q);
    const Interval e2 = sqr(range(at.epsh));
    const Interval J(-(drift_window() * e2 / 8).hi(), (d * sqr(d) * e2 / 4).hi());
    return common(J - range(at.ah), q);
}

}  // namespace

EndBounds end_bounds(const Interval& d) {
    Interval q = hull(Interval(-1) / 10, Interval(3) / 5);
    for (int i = 0; i < end_passes; ++i) {
        q = narrowed(d, q);
    }
    const Last at = last(d, q);
    const Slope x = line(d, Interval(0), Interval(1));

    // g1 = int_0^1 t sinc(2dt) H(pi - 2dt, Q) dt, and the same of second order with J between Q + A and Q.
    const auto [K0, K1] = start_of_H(at.Q);
    const Slope g1 =
        K0 / 2 + K1 * line(d, Interval(0), Interval(2) / 3) + squared(d, 4 * rest_of_H(2 * d, d * q));
    const Slope between = line(d, half_pi<Interval>(), q + hull(range(at.ah), Interval(0)));
    const Slope g2 = second_moment(d, Interval(2), between, end_second_parts);
    const Slope m = midpoint_error(d, Interval(1), at.F, at.Q, x * sinc_of(Interval(1), d), cos_of(d)) +
                    4 * (g1 * at.ah) + 2 * (x * (sqr(at.ah) * g2));

    // e_end/s = -d kh/(4 F sqrt(epsh)) [1, 1 + kappa^2] + m/(2 epsh^(3/2)); eps = d^2 epsh.
    const Slope root = sqrt(at.epsh);
    const Slope per_s = m / (2 * (at.epsh * root)) - x * at.kh / (4 * (at.F * root)) * at.one;
    EndBounds result;
    // Its derivative at d = 0 by L58.
    const Interval half_turn = pi<Interval>(), first = -(sqrt(sqrt(Interval(3))) * (16 * q + Interval(7)) /
                                                         (36 * (half_turn * sqrt(half_turn))));
    result.surplus = (first + d * per_s.second) / range(root);
    result.at_zero = per_s.at0;
    return result;
}

bool certainly_beyond(const Interval& d) {
    const Interval Q = first_window();
    return (sqr(d) * range(last(d, constant(Q)).epsh)).lo() > 0.001;
}

}  // namespace dumbbell::law
