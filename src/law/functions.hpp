#pragma once

#include "law/slope.hpp"

/// The functions of proofs/law.md over boxes.
namespace dumbbell::law {

/// sin x / x, 1 at 0; it falls. Precondition: x in [0, 2.4] up to rounding below 0.
[[nodiscard]] Interval sinc(const Interval& x);

/// A factor in [1 - x, 1]. Precondition: x >= 0.
[[nodiscard]] inline Interval at_most_one(const Interval& x) { return {(1 - x).lo(), 1}; }

/// i/n, and the part [i/n, (i+1)/n].
[[nodiscard]] inline Interval share(int i, int n) { return Interval(i) / Interval(n); }
[[nodiscard]] inline Interval part(int i, int n) { return hull(share(i, n), share(i + 1, n)); }

/// sinc(f U) for f >= 0: 1 - f^2 U^2/6 [1 - f^2 U^2/20, 1].
template <class X>
[[nodiscard]] X sinc_of(const Interval& f, const Interval& U) {
    const Interval x = f * U;
    return quantity<X>(sinc(x), Interval(1), -(sqr(f) * U / 6 * at_most_one(sqr(x) / 20)));
}

/// cos U = 1 - U^2/2 [1 - U^2/12, 1].
template <class X>
[[nodiscard]] X cos_of(const Interval& U) {
    return quantity<X>(cos(U), Interval(1), -(U / 2 * at_most_one(sqr(U) / 12)));
}

/// G(F, Q) = Q/(F sqrt(F^2 - Q^2)) and what the rules need of its derivatives.
template <class X>
[[nodiscard]] X G(const X& F, const X& Q) {
    return Q / (F * sqrt(sqr(F) - sqr(Q)));
}
/// dG/dQ = F (F^2 - Q^2)^(-3/2).
template <class X>
[[nodiscard]] X H(const X& F, const X& Q) {
    const X R = sqr(F) - sqr(Q);
    return F / (R * sqrt(R));
}
/// d2G/dQ2 = 3 Q F (F^2 - Q^2)^(-5/2) over boxes: it falls with F and grows with Q.
[[nodiscard]] Interval H2_monotone(const Interval& F, const Interval& Q);

/// d^i G/dF^i for i = 1, 2, and for i = 3, 4 over boxes only.
template <class X>
struct FirstDerivatives {
    X G1, G2;
};
template <class X>
[[nodiscard]] FirstDerivatives<X> first_derivatives(const X& F, const X& Q) {
    const X R = sqr(F) - sqr(Q), r1 = 1 / sqrt(R), r3 = r1 / R, r5 = r3 / R, f = 1 / F;
    return {-(Q * (sqr(f) * r1 + r3)), Q * (2 * (f * sqr(f) * r1) + f * r3 + 3 * (F * r5))};
}
struct LastDerivatives {
    Interval G3, G4;
};
[[nodiscard]] LastDerivatives last_derivatives(const Interval& F, const Interval& Q);

/// E1/d^3 of proofs/law.md: the midpoint rule's error of int sin x G(pi - x, Q) dx over U - d .. U + d, over
/// d^3. `d_per_U`: d = d_per_U U.
template <class X>
[[nodiscard]] X midpoint_error(const Interval& U, const Interval& d_per_U, const X& F, const X& Q,
                               const X& sin_U, const X& cos_U);

/// int_0^1 t sinc(u t) H2(pi - u t, Q) dt in n equal parts.
[[nodiscard]] Interval second_moment(const Interval& u, const Interval& Q, int n);

/// How far J may lie below pi/2, in units of eps^2/u^3.
[[nodiscard]] inline Interval drift_window() { return Interval(53) / Interval(10); }

/// Where Q of every step of the layer and of the end lies (L53).
[[nodiscard]] inline Interval first_window() {
    return half_pi<Interval>() + hull(Interval(-1) / 100, Interval(1) / 20);
}

/// k0 = 3^(-7/4) pi^(-1/2).
[[nodiscard]] Interval comparison_constant();

/// x as far as it lies in y. NaN, of which every comparison is false, if it nowhere does.
[[nodiscard]] Interval common(const Interval& x, const Interval& y);

/// Whether x certainly lies in [lo, hi]. False for NaN.
[[nodiscard]] inline bool within(const Interval& x, double lo, double hi) {
    return lo <= x.lo() && x.lo() <= x.hi() && x.hi() <= hi;
}

}  // namespace dumbbell::law
