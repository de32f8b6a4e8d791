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

/// (1 - sinc x)/x^2, 1/6 at 0; it falls. Precondition: as of sinc.
[[nodiscard]] Interval sinc_fall(const Interval& x);

/// sinc(f U) and cos(U) for f >= 0.
[[nodiscard]] inline Slope sinc_of(const Interval& f, const Interval& U) {
    return one_and(U, -(sqr(f) * sinc_fall(f * U)), sinc(f * U));
}
[[nodiscard]] inline Slope cos_of(const Interval& U) { return one_and(U, -(sqr(sinc(U / 2)) / 2), cos(U)); }

/// E1/d^3 of proofs/law.md: the midpoint rule's error of int sin x G(pi - x, Q) dx over U - d .. U + d, over
/// d^3. `d_per_U`: d = d_per_U U.
[[nodiscard]] Slope midpoint_error(const Interval& U, const Interval& d_per_U, const Slope& F, const Slope& Q,
                                   const Slope& sin_U, const Slope& cos_U);

/// K0, K1 of K(x) = sinc x g(pi - x) = K0 + K1 x + K2(x) x^2, g = G(., J) or g = H(., Q), H = dG/dQ.
struct Start {
    Slope K0, K1;
};
[[nodiscard]] Start start_of_G(const Slope& J);
[[nodiscard]] Start start_of_H(const Slope& Q);

/// int_0^1 t^3 K2(u t) dt for them, if J or Q is pi/2 + offset.
[[nodiscard]] Interval rest_of_G(const Interval& u, const Interval& offset);
[[nodiscard]] Interval rest_of_H(const Interval& u, const Interval& offset);
/// int_-1^1 (1 + rho t)^3 K2(U (1 + rho t)) dt for H.
[[nodiscard]] Interval step_rest_of_H(const Interval& U, const Interval& rho, const Interval& offset);
/// int_0^1 t sinc(f U t) H2(pi - f U t, Q) dt in n equal parts, H2 = dH/dQ.
[[nodiscard]] Slope second_moment(const Interval& U, const Interval& f, const Slope& Q, int n);

/// How far J may lie below pi/2, in units of eps^2/u^3.
[[nodiscard]] inline Interval drift_window() { return Interval(53) / Interval(10); }

/// Where Q of every step of the layer and of the end lies (L53).
[[nodiscard]] inline Interval first_window() {
    return half_pi<Interval>() + hull(Interval(-1) / 100, Interval(1) / 20);
}

/// k0 = 3^(-7/4) pi^(-1/2).
[[nodiscard]] Interval comparison_constant();

/// c = (4 sqrt3 pi)^(1/2): u is about c sqrt(eps T) near the peak.
[[nodiscard]] Interval clock_constant();

/// x as far as it lies in y. NaN, of which every comparison is false, if it nowhere does.
[[nodiscard]] Interval common(const Interval& x, const Interval& y);

/// Whether x certainly lies in [lo, hi]. False for NaN.
[[nodiscard]] inline bool within(const Interval& x, double lo, double hi) {
    return lo <= x.lo() && x.lo() <= x.hi() && x.hi() <= hi;
}

}  // namespace dumbbell::law
