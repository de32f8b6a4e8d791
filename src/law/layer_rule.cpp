#include "law/layer_rule.hpp"

#include <type_traits>

#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

// With 32 parts for 64 the cover of the layer does not end within ten minutes. 128 would do with 22,432
// leaves instead of 52,301, each of them twice the work.
constexpr int layer_parts = 64;        ///< of the quadratures over t
constexpr int layer_second_parts = 8;  ///< of those in terms of second order
constexpr int layer_passes = 4;        ///< of the iteration that encloses Q

/// The quantities of a step that the rule is made of; (8) and (11) of proofs/law.md.
template <class X>
struct Step {
    X sin_U, cos_U, d, F, Q, ehat;
    X a, a_prime, a_whole;  ///< U^2 (A - A')/d^3, U A'/d^2, U A/d^2
};

template <class X>
Step<X> step(const LayerBox& box, const X& Q) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho, minus = 1 - rho;
    const X u = quantity<X>(U, Interval(0), Interval(1));
    const X d = u * rho;
    const X sinc_d = sinc_of<X>(rho, U), sinc_U = sinc_of<X>(Interval(1), U);
    const X sinc_u = sinc_of<X>(plus, U), sinc_u2 = sinc_of<X>(minus, U);
    const X sinc_2U = sinc_of<X>(Interval(2), U), sinc_2d = sinc_of<X>(2 * rho, U);
    const X cos_U = cos_of<X>(U), sin_U = u * sinc_U;
    const X F = pi<Interval>() - u;
    const X cos_th = Q / F, sin_th = sqrt(1 - sqr(cos_th)), cot_th = cos_th / sin_th;
    const X ehat = sinc_d * sinc_U * cot_th / F;

    // The kicks: tan beta = d b at u, and the same at u'.
    const X b = ehat / (sinc_u * plus), b2 = ehat / (sinc_u2 * minus);
    const X c = 1 / sqrt(1 + sqr(d * b)), c2 = 1 / sqrt(1 + sqr(d * b2));
    const X kc = 4 * (sqr(c) * sqr(c2) / (c + c2) * sqr(ehat) * sinc_2U * sinc_2d /
                      (sqr(sinc_u) * sqr(sinc_u2) * sqr(1 - sqr(rho))));
    const X ks = 4 * (ehat * sinc_2U * sinc_2d * c * c2 /
                      (sinc_u * sinc_u2 * (sinc_u * plus / c + sinc_u2 * minus / c2) * (1 - sqr(rho))));

    const Interval d2 = sqr(range(d));
    const X ratio = sinc_d / sinc_U;
    const X xh = 2 * (sqr(ratio) - sqr(u) * (2 * at_most_one(d2 / 5) / 3)) / (1 - sqr(ratio * rho));
    const X x1 = -((cos_U * sinc_d + sin_U * d * (at_most_one(d2 / 10) / 3)) / (sinc_u2 * minus));
    const X x_prime = x1 * d * rho;
    const X a = cos_th * (c * xh + x_prime * kc * u) + Q * kc * u + sin_th * ks * u;
    const X a_prime = cos_th * c2 * x1 - Q * u * sqr(b2) * sqr(c2) / (1 + c2) - sin_th * u * b2 * c2;
    return {sin_U, cos_U, d, F, Q, ehat, a, a_prime, a_prime + a * rho};
}

/// pi/2 + rho^2 U q.
template <class X>
X Q_of(const LayerBox& box, const Interval& q) {
    const Interval slope = sqr(box.rho) * q;
    return quantity<X>(half_pi<Interval>() + box.U * slope, half_pi<Interval>(), slope);
}

/// That q, from Q = J - A and the window of J.
template <class X>
Interval q_of(const LayerBox& box, const Step<X>& at) {
    const auto& [U, rho] = box;
    const Interval e2 = sqr(range(at.ehat)), plus = 1 + rho;
    const Interval J(-(drift_window() * e2 / (plus * sqr(plus))).hi(), (U * sqr(U) * e2 / 4).hi());
    return J - range(at.a_whole);
}

/// g1, k1 = int_0^1 t sinc(ut) (H at Q, G at J)(pi - ut) dt, and mu.
template <class X>
struct Moments {
    X g1, k1, mu;
};
template <class X>
Moments<X> moments(const LayerBox& box, const Step<X>& at, const X& J) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho;
    const X zero = quantity<X>(Interval(0), Interval(0), Interval(0));
    const X u = quantity<X>(U, Interval(0), Interval(1));
    Moments<X> sum{zero, zero, zero};
    for (int i = 0; i < layer_parts; ++i) {
        const Interval f = plus * part(i, layer_parts),
                       weight = share(2 * i + 1, 2 * layer_parts * layer_parts);
        const X F = pi<Interval>() - u * f, weighted = sinc_of<X>(f, U) * weight;
        sum.g1 = sum.g1 + weighted * H(F, at.Q);
        sum.k1 = sum.k1 + weighted * G(F, J);
    }
    for (int i = 0; i < layer_parts; ++i) {
        // t from t0 = 2i/parts - 1 on, over 2/parts: int (1 + rho t) dt = (2/parts)(1 + rho (t0 + t1)/2)
        const Interval f = 1 + rho * (2 * part(i, layer_parts) - Interval(1));
        const Interval weight =
            (1 + rho * share(2 * i + 1 - layer_parts, layer_parts)) * share(2, layer_parts);
        sum.mu = sum.mu + sinc_of<X>(f, U) * weight * H(pi<Interval>() - u * f, at.Q);
    }
    return sum;
}

template <class X>
LayerBounds bounds(const LayerBox& box) {
    const auto& [U, rho] = box;
    const Interval plus = 1 + rho, minus = 1 - rho;
    Interval q = q_of(box, step<Interval>(box, first_window()));
    for (int i = 0; i < layer_passes; ++i) {
        q = common(q, q_of(box, step<X>(box, Q_of<X>(box, q))));
    }
    const Step<X> at = step<X>(box, Q_of<X>(box, q));
    const X J = at.Q + at.a_whole * at.d * rho;
    const auto [g1, k1, mu] = moments(box, at, J);

    // E2: first order, and the second with J between Q + A (or Q + A') and Q.
    const Interval least = -(max(abs(range(at.a_whole)), abs(range(at.a_prime))) * range(at.d) * rho);
    const Interval between = range(at.Q) + hull(Interval(least.lo()), Interval(0));
    const Interval h1 = second_moment(plus * U, between, layer_second_parts);
    const Interval h2 = second_moment(minus * U, between, layer_second_parts);
    const X E2 = g1 * at.a * sqr(plus) + mu * at.a_prime +
                 at.d * (sqr(at.a_whole) * (sqr(plus) * h1 / 2) - sqr(at.a_prime) * (sqr(minus) * h2 / 2));
    const X m = midpoint_error<X>(U, rho, at.F, at.Q, at.sin_U, at.cos_U) + E2;

    const X rest = k1 * sqr(plus) - at.ehat * (2 * rho);
    const X B = sqrt(k1) * plus + sqrt(rest);
    const Interval scale = 4 * (sqrt(Interval(2)) * comparison_constant());
    const X share_of_D0 = m * B * sqr(B) / (at.ehat * sqr(at.ehat) * scale);
    LayerBounds result;
    result.rest = range(rest);
    result.drift = range(at.a) / (2 * sqr(range(at.ehat)));
    if constexpr (std::is_same_v<X, Slope>) {
        result.gamma = -share_of_D0.slope;
        result.at_zero = share_of_D0.at0;
    } else {
        result.gamma = (1 - share_of_D0) / U;
        result.at_zero = Interval(1);
    }
    return result;
}

}  // namespace

LayerBounds layer_bounds(const LayerBox& box, LayerForm form) {
    return form == LayerForm::slope ? bounds<Slope>(box) : bounds<Interval>(box);
}

bool certainly_beyond(const LayerBox& box) {
    const auto& [U, rho] = box;
    return (rho * sqr(U) * step<Interval>(box, first_window()).ehat).lo() > 0.001;
}

bool closes(const LayerBox& box, LayerForm form) {
    const LayerBounds found = layer_bounds(box, form);
    return certainly_positive(found.rest) && within(Interval(1), found.at_zero.lo(), found.at_zero.hi()) &&
           within(found.gamma, 0.055, box.U.hi() > 0.75 ? 1.10 : 1.29) && within(found.drift, 0, 15.88);
}

}  // namespace dumbbell::law
