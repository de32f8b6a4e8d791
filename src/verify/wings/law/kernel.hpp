// The clock's integrand G(F, Q) = Q/(F sqrt(F^2 - Q^2)), its derivatives and its moments (law.md).
#pragma once
#include "verify/wings/law/slope.hpp"

namespace dumbbell_verify::law {

/// d/dF and d^2/dF^2.
template <class T>
struct Bends {
    T first, second;
};
/// Of G.
template <class N, class T>
Bends<T> bends(const T& F, const T& Q) {
    using I = Interval<N>;
    const T R = square(F) - square(Q), r1 = I(1) / square_root(R), f = I(1) / F;
    const T r3 = r1 / R, r5 = r3 / R;
    return {-(Q * (square(f) * r1 + r3)), Q * (I(2) * cube(f) * r1 + f * r3 + I(3) * F * r5)};
}
/// Of H = dG/dQ = F (F^2 - Q^2)^(-3/2).
template <class N>
Bends<Interval<N>> bends_of_H(const Interval<N>& F, const Interval<N>& Q) {
    using I = Interval<N>;
    const I R = square(F) - square(Q), r3 = I(1) / (R * square_root(R)), r5 = r3 / R, r7 = r5 / R;
    return {r3 - I(3) * square(F) * r5, I(15) * cube(F) * r7 - I(9) * F * r5};
}
/// d^3/dF^3 and d^4/dF^4 of G.
template <class N>
struct FarBends {
    Interval<N> third, fourth;
};
template <class N>
FarBends<N> far_bends(const Interval<N>& F, const Interval<N>& Q) {
    using I = Interval<N>;
    const I R = square(F) - square(Q), r1 = I(1) / square_root(R), r3 = r1 / R, r5 = r3 / R, r7 = r5 / R,
            r9 = r7 / R, f = I(1) / F, f2 = square(f);
    return {-(Q * (I(6) * square(f2) * r1 + I(3) * f2 * r3 + I(15) * square(F) * r7)),
            Q * (I(24) * square(f2) * f * r1 + I(12) * f * f2 * r3 + I(9) * f * r5 - I(30) * F * r7 +
                 I(105) * cube(F) * r9)};
}

/// (E1)/d^3, E1 the integral of sin(U + y) (G(F - y, Q) - G(F, Q)) over |y| <= d, with d = rho U: the even
/// part needs G'' and G'''', the odd part G' and G'''; far: G''' and G'''' on [F - d, F + d].
template <class N>
Slope<N> middle_error(const Along<N>& along, const Slope<N>& sin_U, const Slope<N>& cos_U, const Slope<N>& F,
                      const Slope<N>& Q, const Interval<N>& rho) {
    using I = Interval<N>;
    const I U = along.U, d = rho * U, d2 = square(d), rho2 = square(rho), middle = pi<N>() - U;
    // Integrals over [0, d]: y^2 cos y, y sin y, y^4 cos y, y^3 sin y, over d^3 (alternating series).
    const I third = fraction<N>(1, 3);
    const Slope<N> I2 = along.curve(third, -(rho2 / I(10) * below_one(d2, fraction<N>(5, 84))));
    const Slope<N> J1 = along.curve(third, -(rho2 / I(30) * below_one(d2, fraction<N>(1, 28))));
    const Slope<N> I4 = along.curve(0, rho2 / I(5) * below_one(d2, fraction<N>(1, 2)));
    const Slope<N> J3 = along.curve(0, rho2 / I(5) * below_one(d2, fraction<N>(1, 6)));
    const FarBends<N> far = far_bends<N>({(middle - d).lo, (middle + d).hi}, along.values(Q));
    const Bends<Slope<N>> G = bends<N>(F, Q);
    return sin_U * (G.second * I2 + along.times(I4, far.fourth / I(12))) -
           I(2) * (cos_U * (G.first * J1 + along.times(J3, far.third / I(6))));
}

/// Integrals over the way from u = 0, of f(x) = sinc(x) g(pi - x) with g = G(., J) or H(., Q). Each part of
/// the way has its node where t has its mean: so what is left is f'' on the part, times U^2.
template <class N>
class Moments {
    using I = Interval<N>;
    using S = Slope<N>;

  public:
    explicit Moments(const Along<N>& along) : along_(along) {}

    /// The integral of t f(p U t) over t in [0, 1], for G and for H.
    [[nodiscard]] S way_G(const I& p, const S& J, int parts) const {
        return over_way(
            p, parts, [&](const I& k) { return at_G(k, J); }, second_G(p * I(N(0), N(1)), J));
    }
    [[nodiscard]] S way_H(const I& p, const S& Q, int parts) const {
        return over_way(
            p, parts, [&](const I& k) { return at_H(k, Q); }, second_H(p * I(N(0), N(1)), Q));
    }
    /// The integral of (1 + rho t) f(U (1 + rho t)) over t in [-1, 1], for H: the node is at t = rho/3.
    [[nodiscard]] S step_H(const I& rho, const S& Q) const {
        const I spread(-rho.hi, rho.hi), rho2 = square(rho), third = fraction<N>(1, 3);
        const I second = second_H(I(1) + spread, Q) * rho2 * (third - rho2 / I(9));
        return at_H(I(1) + rho2 * third, Q) * I(2) + along_.curve(0, second);
    }
    /// The integral of t sinc(x) H2(pi - x, X), x = p U t, over t in [0, 1], H2 = 3 X F (F^2 - X^2)^(-5/2).
    [[nodiscard]] S second_order(const I& p, const S& X) const {
        S sum = along_.line(0, 0);
        constexpr int parts = 8;
        for (int i = 0; i < parts; ++i) {
            const I t(fraction<N>(i, parts).lo, fraction<N>(i + 1, parts).hi);
            const S F = along_.line(pi<N>(), -(p * t)), R = square(F) - square(X);
            sum = sum + along_.sinc_of(p * t) * (I(3) * X * F / (square(R) * square_root(R))) *
                            fraction<N>(2 * i + 1, 2 * parts * parts);
        }
        return sum;
    }

  private:
    template <class Function>
    [[nodiscard]] S over_way(const I& p, int parts, const Function& f, const I& second) const {
        S sum = along_.line(0, 0);
        I spread = 0;  // the integral of t (t - node)^2/2
        for (int i = 0; i < parts; ++i) {
            const I a = fraction<N>(i, parts), b = fraction<N>(i + 1, parts);
            const I weight = (square(b) - square(a)) / I(2), moment = (cube(b) - cube(a)) / I(3);
            const I node = moment / weight;
            sum = sum + f(p * node) * weight;
            spread = spread + ((square(square(b)) - square(square(a))) / I(4) - node * moment) / I(2);
        }
        return sum + along_.curve(0, square(p) * (spread * second));
    }
    [[nodiscard]] S at_G(const I& k, const S& J) const {
        const S F = along_.line(pi<N>(), -k);
        return along_.sinc_of(k) * (J / (F * square_root(square(F) - square(J))));
    }
    [[nodiscard]] S at_H(const I& k, const S& Q) const {
        const S F = along_.line(pi<N>(), -k), R = square(F) - square(Q);
        return along_.sinc_of(k) * (F / (R * square_root(R)));
    }
    /// f'' at x = k U.
    [[nodiscard]] I second_G(const I& k, const S& J) const {
        const I F = pi<N>() - k * along_.U, X = along_.values(J), R = square(F) - square(X);
        return second(k * along_.U, X / (F * square_root(R)), bends<N, I>(F, X));
    }
    [[nodiscard]] I second_H(const I& k, const S& Q) const {
        const I F = pi<N>() - k * along_.U, X = along_.values(Q), R = square(F) - square(X);
        return second(k * along_.U, F / (R * square_root(R)), bends_of_H(F, X));
    }
    /// sinc'' g - 2 sinc' g_F + sinc g_FF; sinc' lies in -(x/3) [1 - x^2/10, 1], sinc'' in -1/3 + [0,
    /// x^2/10].
    static I second(const I& x, const I& g, const Bends<I>& by_F) {
        const I x2 = square(x), third = fraction<N>(1, 3);
        const I turn = -(x * third * below_one(x2, fraction<N>(1, 10)));
        const I curve((-third).lo, (x2 / I(10) - third).hi);
        return curve * g - I(2) * turn * by_F.first + sinc(x) * by_F.second;
    }

    const Along<N>& along_;
};

}  // namespace dumbbell_verify::law
