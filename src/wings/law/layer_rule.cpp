#include "law/layer_rule.hpp"

#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

constexpr int second_parts = 8;  ///< of the quadratures in the terms of second order
constexpr int passes = 4;        ///< of the iteration that encloses Q

/// (C6), (C7): the excess lies between a y + b (sqrt T - sqrt(T - 1))^2, a = -0.155 and b = -0.43 below, a =
/// 0.125 and b = 0.45 above. In thousandths, with something to spare for the verifier's wider enclosures.
constexpr int a_least = -131, b_least = -340, a_most = 90, b_most = 345;

/// The quantities of a step that the rule is made of; (8) and (11) of proofs/law.md. What is 1 at U = 0 is
/// written without the factors of rho that cancel: so the wide sums of L50 (b) do not occur.
struct Step {
    Slope sin_U, cos_U, d, F, Q, ehat;
    Slope a, apart;          ///< (1 - rho^2) a, and (ap + (1 + rho) a/2)/U
    Slope a_prime, a_whole;  ///< ap, aA
};

Step step(const LayerBox& box, const Slope& Q) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho, minus = 1 - rho, less = 1 - sqr(rho);
    const Slope u = line(U, Interval(0), Interval(1)), d = u * rho;
    const Slope sinc_d = sinc_of(rho, U), sinc_U = sinc_of(Interval(1), U);
    const Slope sinc_u = sinc_of(plus, U), sinc_u2 = sinc_of(minus, U);
    const Slope cos_U = cos_of(U), sin_U = u * sinc_U, F = line(U, pi<Interval>(), Interval(-1));
    const Slope cos_th = Q / F, sin_th = sqrt(1 - sqr(cos_th));
    const Slope ehat = sinc_d * sinc_U * (cos_th / sin_th) / F;

    // The kicks: tan beta = d b at u, and the same at u'.
    const Slope b = ehat / (sinc_u * plus), b2 = ehat / (sinc_u2 * minus);
    const Slope c = 1 / sqrt(1 + sqr(d * b)), c2 = 1 / sqrt(1 + sqr(d * b2));
    const Slope both = sinc_u * sinc_u2 * less;
    const Slope doubles = 4 * (ehat * sinc_of(Interval(2), U) * sinc_of(2 * rho, U));
    const Slope kc = sqr(c) * sqr(c2) / (c + c2) * ehat * doubles / sqr(both);
    const Slope ks = doubles * c * c2 / (both * (sinc_u * plus / c + sinc_u2 * minus / c2));

    // x = (1 - rho^2) xh/2 and x1 = -(1 - rho) X1, both 1 at U = 0.
    const Interval d2 = sqr(range(d));
    const Slope ratio = sqr(sinc_d / sinc_U);
    const Interval top = ratio.second - 2 * at_most_one(d2 / 5) / 3;
    const Slope x = one_and(U, top, 1 + sqr(U) * top) /
                    one_and(U, -(sqr(rho) * ratio.second / less), (1 - sqr(rho) * range(ratio)) / less);
    const Slope x1 = (cos_U * sinc_d + sin_U * d * (at_most_one(d2 / 10) / 3)) / sinc_u2;
    const Slope cx = c * x, cx1 = c2 * x1;

    const Slope turn = Q * kc + sin_th * ks - cos_th * x1 * d * (rho / minus) * kc;
    const Slope kick = Q * sqr(b2) * sqr(c2) / (1 + c2) + sin_th * b2 * c2;
    const Slope a = 2 * (cos_th * cx) + u * turn * less;
    const Slope a_prime = -(cos_th * cx1 / minus) - u * kick;
    const Slope apart =
        cos_th * line(U, Interval(0), (cx.second - cx1.second) / minus) + turn * (plus / 2) - kick;
    return {sin_U, cos_U, d, F, Q, ehat, a, apart, a_prime, a_prime + a * (rho / less)};
}

/// pi/2 + rho^2 U q.
Slope Q_of(const LayerBox& box, const Interval& q) {
    return line(box.U, half_pi<Interval>(), sqr(box.rho) * q);
}

/// (J - pi/2)/(rho^2 U), by its window.
Interval J_offset(const LayerBox& box, const Step& at) {
    const auto& [U, rho] = box;
    const Interval e2 = sqr(range(at.ehat)), plus = 1 + rho;
    return {-(drift_window() * e2 / (plus * sqr(plus))).hi(), (U * sqr(U) * e2 / 4).hi()};
}
/// That q, as Q = J - A.
Interval q_of(const LayerBox& box, const Step& at) { return J_offset(box, at) - range(at.a_whole); }

/// m of L49, 2 eps D = m d^3: with (1 + rho)^2 g1 a + mu ap = mu (ap + (1 + rho) a/2) - (1 - rho^2) a both/2,
/// both = (mu - 2 (1 + rho) g1)/(1 - rho).
Slope defect(const LayerBox& box, const Step& at, const Interval& q) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho, minus = 1 - rho, offset = sqr(rho) * U * q;
    const auto [H0, H1] = start_of_H(at.Q);
    const Interval step_rest = step_rest_of_H(U, rho, offset), way_rest = rest_of_H(plus * U, offset);
    const Slope mu = 2 * H0 + H1 * line(U, Interval(0), 2 + 2 * sqr(rho) / 3) + squared(U, step_rest);
    const Slope both = H0 + H1 * line(U, Interval(0), Interval(4) / 3) +
                       squared(U, (step_rest - 2 * plus * sqr(plus) * way_rest) / minus);
    // The terms of second order, with J between Q + A (or Q + A') and Q.
    const Interval least = -max(abs(range(at.a_whole)), abs(range(at.a_prime)));
    const Slope between = Q_of(box, q + hull(Interval(least.lo()), Interval(0)));
    const Slope h1 = second_moment(U, plus, between, second_parts),
                h2 = second_moment(U, minus, between, second_parts);
    return midpoint_error(U, rho, at.F, at.Q, at.sin_U, at.cos_U) +
           line(U, Interval(0), Interval(1)) * mu * at.apart - at.a * both / 2 +
           at.d * (sqr(at.a_whole) * h1 * sqr(plus) - sqr(at.a_prime) * h2 * sqr(minus)) / 2;
}

/// `x`, of which it is known that it is 1 at U = 0.
Slope normalised(Slope x) {
    x.at0 = Interval(1);
    return x;
}

Margin margin(const LayerBox& box, const Interval& by_rho, const Interval& by_U) {
    return {by_rho, by_U, box.rho * by_rho + box.U * by_U};
}
bool is_positive(const Margin& margin) {
    return (certainly_positive(margin.by_rho) && certainly_positive(margin.by_U)) ||
           certainly_positive(margin.sum);
}

}  // namespace

LayerBounds layer_bounds(const LayerBox& box) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho, minus = 1 - rho, half_turn = pi<Interval>();
    Interval q = q_of(box, step(box, constant(first_window())));
    for (int i = 0; i < passes; ++i) {
        q = common(q, q_of(box, step(box, Q_of(box, q))));
    }
    const Step at = step(box, Q_of(box, q));

    // B = sqrt(ehat/2) (2 + ...): its two roots are those of k = 2 k1/ehat and of 1 + (k - 1)
    // (1+rho)^2/(1-rho)^2.
    const Interval j = J_offset(box, at);
    const auto [G0, G1] = start_of_G(at.Q + at.a_whole * at.d * rho);
    const Slope k1 = G0 / 2 + G1 * line(U, Interval(0), plus / 3) +
                     squared(U, sqr(plus) * rest_of_G(plus * U, sqr(rho) * U * j));
    const Slope k = normalised(2 * (k1 / at.ehat)),
                rest = normalised((k - 1) * sqr(plus / minus) + Interval(1));
    const Slope half_B = normalised((sqrt(k) * plus + sqrt(rest) * minus) / 2), root = sqrt(at.ehat);
    const Slope ratio =
        defect(box, at, q) * half_B * sqr(half_B) / (at.ehat * root) / (2 * comparison_constant());

    // y = U v; by L57 (1 - ratio)/U - 5 v/(3 pi) = rho^2 turn + U bend.
    const Slope v = half_B * root * (clock_constant() / 2);
    const Interval gamma = 5 / (3 * half_turn), turn = (12 * q - 1 / minus) / (3 * half_turn);
    const Interval bend = -(ratio.second + gamma * v.slope);
    const Interval by_rho = rho * turn / range(v), by_U = bend / range(v), spread = 1 / sqr(range(half_B));
    LayerBounds result;
    result.rest = range(rest);
    result.excess = rho * by_rho + U * by_U;
    const auto thousandths = [](int n) { return Interval(n) / 1000; };
    result.above =
        margin(box, by_rho - thousandths(b_least) * spread, by_U - thousandths(a_least) * range(v));
    result.below = margin(box, thousandths(b_most) * spread - by_rho, thousandths(a_most) * range(v) - by_U);
    result.drift = range(at.a) / (2 * sqr(range(at.ehat)) * (1 - sqr(rho)));
    result.at_zero = ratio.at0;
    result.first = ratio.first + gamma + sqr(rho) * turn;
    return result;
}

bool certainly_beyond(const LayerBox& box) {
    return (box.rho * sqr(box.U) * range(step(box, constant(first_window())).ehat)).lo() > 0.001;
}

bool closes(const LayerBox& box) {
    const LayerBounds found = layer_bounds(box);
    const auto contains = [](const Interval& x, double value) { return x.lo() <= value && value <= x.hi(); };
    return certainly_positive(found.rest) && is_positive(found.above) && is_positive(found.below) &&
           within(found.drift, 0, 15.88) && contains(found.at_zero, 1) && contains(found.first, 0);
}

}  // namespace dumbbell::law
