// The clock's integrand G(F, Q) = Q/(F sqrt(F^2 - Q^2)), its derivatives and its moments (law.md).
#pragma once
#include "verify/law/slope.hpp"

namespace dumbbell_verify::law {

/// d/dF and d^2/dF^2 of G.
template <class T>
struct Bends {
    T first, second;
};
template <class N, class T>
Bends<T> bends(const T& F, const T& Q) {
    using I = Interval<N>;
    const T R = square(F) - square(Q), r1 = I(1) / square_root(R), f = I(1) / F;
    const T r3 = r1 / R, r5 = r3 / R;
    return {-(Q * (square(f) * r1 + r3)), Q * (I(2) * cube(f) * r1 + f * r3 + I(3) * F * r5)};
}
/// d^3/dF^3 and d^4/dF^4.
template <class T>
struct FarBends {
    T third, fourth;
};
template <class N, class T>
FarBends<T> far_bends(const T& F, const T& Q) {
    using I = Interval<N>;
    const T R = square(F) - square(Q), r1 = I(1) / square_root(R), r3 = r1 / R, r5 = r3 / R, r7 = r5 / R,
            r9 = r7 / R, f = I(1) / F, f2 = square(f);
    return {-(Q * (I(6) * square(f2) * r1 + I(3) * f2 * r3 + I(15) * square(F) * r7)),
            Q * (I(24) * square(f2) * f * r1 + I(12) * f * f2 * r3 + I(9) * f * r5 - I(30) * F * r7 +
                 I(105) * cube(F) * r9)};
}

/// (E1)/d^3, E1 the integral of sin(U + y) (G(F - y, Q) - G(F, Q)) over |y| <= d, with d = rho U: the even
/// part needs G'' and G'''', the odd part G' and G'''; far: G''' and G'''' on [F - d, F + d].
template <class N, template <class> class Form>
Form<N> middle_error(const Along<N, Form>& along, const Form<N>& sin_U, const Form<N>& cos_U,
                     const Form<N>& F, const Form<N>& Q, const Interval<N>& rho) {
    using I = Interval<N>;
    using T = Form<N>;
    using Factor = typename Along<N, Form>::Factor;
    const I third = fraction<N>(1, 3);
    const Factor U = along.U, d = rho * U, middle = pi<N>() - U;
    // Integrals over [0, d]: y^2 cos y, y sin y, y^4 cos y, y^3 sin y, over d^3 (alternating series).
    const T I2 = along.nearly(third, rho, fraction<N>(3, 10), fraction<N>(5, 84));
    const T J1 = along.nearly(third, rho, fraction<N>(1, 10), fraction<N>(1, 28));
    const T d2 = square(along.line(0, rho)) / I(5);
    const T I4 = d2 * below_one(square(d), fraction<N>(1, 2)),
            J3 = d2 * below_one(square(d), fraction<N>(1, 6));
    const Factor most = middle + d, least = middle - d, beside(I(values_of(least).lo, values_of(most).hi));
    const FarBends<Factor> far = far_bends<N>(beside, along.values(Q));
    const Bends<T> G = bends<N>(F, Q);
    return sin_U * (G.second * I2 + I4 * (far.fourth / I(12))) -
           I(2) * (cos_U * (G.first * J1 + J3 * (far.third / I(6))));
}

/// d/dx of sinc(x) g(pi - x), where g has the derivative g_F.
template <class N, class T>
T falling_product(const T& x, const T& g, const T& g_F) {
    using I = Interval<N>;
    const T turn = -(x / I(3) * below_one(square(x), fraction<N>(1, 10)));  // sinc'
    return turn * g - sinc(x) * g_F;
}

/// Integrals over the way from u = 0, of f(x) = sinc(x) g(pi - x) with g = G(., J) or H(., Q), H = dG/dQ. On
/// each part of the way f(x) = f(middle) + (x - middle) f'(somewhere): the middle with its slope in U, f' as
/// an interval on the part.
template <class N, template <class> class Form>
class Moments {
    using I = Interval<N>;
    using T = Form<N>;
    using Factor = typename Along<N, Form>::Factor;

  public:
    Moments(const Along<N, Form>& along, const T& Q, const T& J)
        : along_(along), Q_(Q), J_(J), whole_Q_(along.values(Q)), whole_J_(along.values(J)) {}

    struct Pair {
        T G, H;
    };
    /// The integrals of t f(p U t) over t in [0, 1].
    [[nodiscard]] Pair over_way(const I& p, int parts) const {
        Pair sum{along_.line(0, I(0)), along_.line(0, I(0))};
        Factor rise_G(I(0)), rise_H(I(0));
        const I h = fraction<N>(1, parts), beyond = cube(h) / I(24);
        for (int i = 0; i < parts; ++i) {
            const I middle = fraction<N>(2 * i + 1, 2 * parts), weight = middle * h;
            const Pair f = at(p * middle);
            sum.G = sum.G + f.G * weight;
            sum.H = sum.H + f.H * weight;
            const I t(fraction<N>(i, parts).lo, fraction<N>(i + 1, parts).hi);
            const auto [slope_G, slope_H] = slopes(p * t);
            // The integrals of t |t - middle| over both halves of the part.
            const I half = weight * h / I(8), right = half + beyond, left = half - beyond;
            rise_G = rise_G + (slope_G * right - slope_G * left);
            rise_H = rise_H + (slope_H * right - slope_H * left);
        }
        return {sum.G + along_.line(0, p * rise_G), sum.H + along_.line(0, p * rise_H)};
    }
    /// The integral of (1 + rho t) f(U (1 + rho t)) over t in [-1, 1], for H.
    [[nodiscard]] T over_step(const I& rho) const {
        const I spread(-rho.hi, rho.hi);
        const Factor slope = slopes(I(1) + spread).second;
        const I right = fraction<N>(1, 2) + rho / I(3), left = fraction<N>(1, 2) - rho / I(3);
        return at(1).H * I(2) + along_.line(0, rho * (slope * right - slope * left));
    }
    /// Encloses the integral of t sinc(x) H2(pi - x, X), x = p U t, over t in [0, 1], H2 = 3 X F (F^2 -
    /// X^2)^(-5/2).
    [[nodiscard]] Factor second_order(const I& p, const Factor& X) const {
        Factor sum(I(0));
        constexpr int quarters = 4;
        for (int i = 0; i < quarters; ++i) {
            const I t(fraction<N>(i, quarters).lo, fraction<N>(i + 1, quarters).hi);
            const Factor x = along_.U * p * t, F = pi<N>() - x, R = square(F) - square(X);
            sum = sum + sinc(x) * (I(3) * X * F / (square(R) * square_root(R))) *
                            fraction<N>(2 * i + 1, 2 * quarters * quarters);
        }
        return sum;
    }

  private:
    [[nodiscard]] Pair at(const I& k) const {
        const T wave = along_.sinc_of(k), F = along_.line(pi<N>(), -k);
        const T by_Q = square(F) - square(Q_), by_J = square(F) - square(J_);
        return {wave * (J_ / (F * square_root(by_J))), wave * (F / (by_Q * square_root(by_Q)))};
    }
    /// f' of both at x = k U.
    [[nodiscard]] std::pair<Factor, Factor> slopes(const I& k) const {
        const Factor x = k * along_.U, F = pi<N>() - x, f = I(1) / F;
        const Factor R_J = square(F) - square(whole_J_), j1 = I(1) / square_root(R_J), j3 = j1 / R_J;
        const Factor R = square(F) - square(whole_Q_), r3 = I(1) / (R * square_root(R));
        return {falling_product<N, Factor>(x, whole_J_ * f * j1, -(whole_J_ * (square(f) * j1 + j3))),
                falling_product<N, Factor>(x, F * r3, r3 - I(3) * square(F) * r3 / R)};
    }

    const Along<N, Form>& along_;
    const T &Q_, &J_;
    const Factor whole_Q_, whole_J_;
};

}  // namespace dumbbell_verify::law
