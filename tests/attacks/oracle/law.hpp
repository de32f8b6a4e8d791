// proofs/law.md in plain numbers of 80 digits or long double: the clock, and a step of the layer with every
// number of L49 as the range that its interval factors leave. Nothing is rounded outwards: this tries
// formulas.
#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "scalar.hpp"

namespace dumbbell_oracle::law {

template <class S, class F>
[[nodiscard]] S integral(const F& f, const S& from, const S& to) {
    constexpr unsigned points = std::is_same_v<S, Digits80> ? 100 : 30;
    return from == to ? S(0) : S(boost::math::quadrature::gauss<S, points>::integrate(f, from, to));
}

template <class S>
[[nodiscard]] S sinc(const S& x) {
    using std::sin;
    return x == 0 ? S(1) : S(sin(x) / x);
}

template <class S>
[[nodiscard]] S g(const S& f, const S& j) {  // G(F, J)
    using std::sqrt;
    return S(j / (f * sqrt(f * f - j * j)));
}

// tau(u, J), for u well below pi/2.
template <class S>
[[nodiscard]] S tau(const S& u, const S& j) {
    using std::sin;
    return integral<S>([&](const S& x) { return S(sin(x) * g(S(pi<S>() - x), j)); }, S(0), u);
}

// S(J, x): tau by the angle.
template <class S>
[[nodiscard]] S tau_by_angle(const S& x, const S& j) {
    using std::acos;
    using std::cos;
    using std::sin;
    return integral<S>([&](const S& a) { return S(sin(j / cos(a))); }, x, S(acos(j / pi<S>())));
}

template <class S>
[[nodiscard]] S k0() {
    using std::pow;
    using std::sqrt;
    return S(pow(S(3), S(-7) / 4) / sqrt(pi<S>()));
}

// c of L57.
template <class S>
[[nodiscard]] S clock_constant() {
    using std::sqrt;
    return S(2 * sqrt(sqrt(S(3)) * pi<S>()));
}

template <class S>
[[nodiscard]] S comparison(const S& s, const S& t) {  // D0(T)
    using std::sqrt;
    const S sum = sqrt(t) + sqrt(t - 1);
    return S(k0<S>() * s / (sum * sum * sum));
}

struct Range {
    Digits80 lo, hi;

    Range(const Digits80& x) : lo(x), hi(x) {}
    Range(const Digits80& a, const Digits80& b) : lo(std::min(a, b)), hi(std::max(a, b)) {}
    [[nodiscard]] bool has(const Digits80& x) const {
        const Digits80 slack = (1 + abs(x)) * Digits80(1e-30);
        return lo - slack <= x && x <= hi + slack;
    }
};
inline Range operator+(const Range& a, const Range& b) {
    return {Digits80(a.lo + b.lo), Digits80(a.hi + b.hi)};
}
inline Range operator-(const Range& a) { return {Digits80(-a.hi), Digits80(-a.lo)}; }
inline Range operator-(const Range& a, const Range& b) { return a + -b; }
inline Range operator*(const Range& a, const Range& b) {
    const auto [lo, hi] = std::minmax(
        {Digits80(a.lo * b.lo), Digits80(a.lo * b.hi), Digits80(a.hi * b.lo), Digits80(a.hi * b.hi)});
    return {lo, hi};
}
inline Range up_to_1(const Digits80& short_of) {
    return {Digits80(1 - short_of), Digits80(1)};
}  // [1 - x, 1]

// A step in the coordinates of L43 (b), and its two contacts.
template <class S>
struct Step {
    S U, rho, Q, d, F, th, eps, u, v, beta, beta_v, j, j_v;  // v, beta_v, j_v: u', beta', J'

    Step(const S& u_mean, const S& share, const S& q) : U(u_mean), rho(share), Q(q) {
        using std::acos;
        using std::atan;
        using std::cos;
        using std::sin;
        using std::tan;
        d = rho * U;
        F = pi<S>() - U;
        th = acos(Q / F);
        eps = sin(d) * sin(U) / (tan(th) * F);
        u = U + d;
        v = U - d;
        beta = atan(eps / sin(u));
        beta_v = atan(eps / sin(v));
        j = (pi<S>() - u) * cos(th - beta);
        j_v = (pi<S>() - v) * cos(th + beta_v);
    }
    [[nodiscard]] S alpha() const { return th - beta; }
    [[nodiscard]] S alpha_v() const { return th + beta_v; }
};

struct Layer {  // L49 (11) and L50, at U >= 0
    Digits80 ehat;
    Range a = Digits80(0), a_first = Digits80(0), a_second = Digits80(0), m = Digits80(0),
          ratio = Digits80(0);  // aA, ap, Rr
};
[[nodiscard]] Layer layer(const Digits80& U, const Digits80& rho, const Digits80& Q);

struct Derivatives {  // of G by F
    Digits80 g1, g2, g3, g4;
};
[[nodiscard]] Derivatives derivatives(const Digits80& f, const Digits80& q);

// m1 of L49, for the end too.
[[nodiscard]] Range first_part(const Digits80& U, const Digits80& d, const Digits80& Q);

// integral_0^1 t sinc(ut) h(pi - ut) dt.
template <class H>
[[nodiscard]] Digits80 moment(const Digits80& u, const H& h) {
    return integral<Digits80>(
        [&](const Digits80& t) {
            return Digits80(t * sinc(Digits80(u * t)) * h(Digits80(pi<Digits80>() - u * t)));
        },
        Digits80(0), Digits80(1));
}
[[nodiscard]] inline Digits80 h_of(const Digits80& f, const Digits80& j) {
    return Digits80(f / pow(f * f - j * j, Digits80(1.5)));
}
[[nodiscard]] inline Digits80 h2_of(const Digits80& f, const Digits80& j) {
    return Digits80(3 * j * f / pow(f * f - j * j, Digits80(2.5)));
}

}  // namespace dumbbell_oracle::law
