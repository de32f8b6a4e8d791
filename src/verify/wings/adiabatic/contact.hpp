// What the lemmas L33 to L38 are written in: the masses by delta, and a contact of the light mass.
#pragma once
#include "verify/functions/angle.hpp"
#include "verify/machine/meter.hpp"
#include "verify/wings/adiabatic/arcsine.hpp"

namespace dumbbell_verify::adiabatic {

/// x^(n/16) for x >= 0.
template <class N>
Interval<N> sixteenths(const Interval<N>& x, unsigned n) {
    Interval<N> power = 1;
    for (; n >= 16; n -= 16) power = power * x;
    if (n == 0) return power;
    const Interval<N> part = root(root(root(root(x))));
    for (; n > 0; --n) power = power * part;
    return power;
}

/// epsilon = beta1 = delta^2, 0 <= delta < 1/2; r is the light mass over the heavy one.
template <class N>
struct Masses {
    using I = Interval<N>;
    explicit Masses(const I& interval)
        : delta(interval),
          beta2(I(1) - square(delta)),
          r(square(delta) / beta2),
          root_r(delta / root(beta2)),
          r_over_delta(delta / beta2) {}
    I delta, beta2, r, root_r, r_over_delta;
};

/// A contact of the light mass at corner distance x in [0, pi/2], with sin x and w = cos x > 0.
template <class N>
struct Touch {
    using I = Interval<N>;
    /// At distance u of the rod from the vertical.
    static Touch at(const Masses<N>& m, const I& u, const I& quarter) {
        const auto [w, sine] = sin_cos_on(u, quarter);
        return {m, quarter - u, sine, w};
    }
    Touch(const Masses<N>& m, const I& distance, const I& sin_x, const I& cos_x)
        : x(distance), sine(sin_x), w(cos_x), square_w(square(w)), e(m.r / square_w) {
        Meter::spend(1 << 13);
        const I quarter = pi<N>() / I(2);
        const Excess excess(m.beta2, m.r, sine, w);
        rho = excess.rho;
        asin_over_r = excess.asin_over_r;
        asin_Z = m.r * asin_over_r;
        F = quarter + x;
        // f increases with x and beta2: its own values at the ends are nearer than F - asin Z of the
        // intervals.
        const auto at = [&](const N& end, const I& beta2) {
            const auto [end_sine, end_w] = sin_cos_on(I(end), quarter);
            const I r = (I(1) - beta2) / beta2;
            return quarter + end - r * Excess(beta2, r, end_sine, end_w).asin_over_r;
        };
        f = {at(x.lo, m.beta2.lo).lo, at(x.hi, m.beta2.hi).hi};
    }
    /// h(x, kappa): S over |phidot| before a collision with this slope (L33).
    [[nodiscard]] I h(const I& kappa) const { return f * (I(1) - kappa / w) / (I(1) + e); }

    I x, sine, w, square_w;
    I e;                    ///< r/w^2
    I rho;                  ///< sqrt(1 - y^2)/beta2, y the height of the centre of mass
    I asin_Z, asin_over_r;  ///< F - f = asin Z >= 0, and over r
    I F, f;                 ///< pi/2 + x, pi - arccos y

  private:
    /// asin Z over r, from zeta = Z/r: no division by r, which may be 0.
    struct Excess {
        Excess(const I& beta2, const I& r, const I& s, const I& cosine)
            : rho(root(square(cosine) + I(2) * r + square(r))) {
            const I zeta = beta2 * s * (I(2) + r) / (rho + cosine);
            asin_over_r = zeta * arcsine_share(r * zeta);
        }
        I rho, asin_over_r;
    };
};

}  // namespace dumbbell_verify::adiabatic
