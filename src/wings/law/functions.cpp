#include "law/functions.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace dumbbell::law {
namespace {

constexpr int rest_parts = 24, step_parts = 6;

/// The series of sinc from its k-th bracket on: 1 - y/6 (1 - y/20 (1 - y/42 (...))), y = x^2. For y <= 6 each
/// bracket lies in [0, 1] if the one in it does, so the last one may be replaced by [0, 1].
Interval bracket_at(double x, std::size_t k) {
    constexpr int last = 12;
    static const std::array<Interval, last> factors = [] {
        std::array<Interval, last> result;
        for (int i = 1; i <= last; ++i) {
            result[static_cast<std::size_t>(i - 1)] = Interval(1) / Interval(2 * i * (2 * i + 1));
        }
        return result;
    }();
    const Interval y = sqr(Interval(x));
    std::size_t terms = last;
    if (y.hi() < 0.01) {
        terms = 6;
    } else if (y.hi() > 6) {
        return {-1, 1};
    }
    Interval bracket(0, 1);
    for (std::size_t i = terms; i-- > k;) {
        bracket = 1 - y * factors[i] * bracket;
    }
    return bracket;
}
Interval falling_bracket(const Interval& x, std::size_t k) {
    if (x.is_nan()) {
        return x;
    }
    return {bracket_at(std::max(0.0, x.hi()), k).lo(), bracket_at(std::max(0.0, x.lo()), k).hi()};
}

Slope G(const Slope& F, const Slope& Q) { return Q / (F * sqrt(sqr(F) - sqr(Q))); }
Slope H(const Slope& F, const Slope& Q) {
    const Slope R = sqr(F) - sqr(Q);
    return F / (R * sqrt(R));
}
Slope H2(const Slope& F, const Slope& Q) {
    const Slope R = sqr(F) - sqr(Q);
    return 3 * (Q * F) / (sqr(R) * sqrt(R));
}

/// d^i G/dF^i for i = 1, 2, and for i = 3, 4 over boxes only.
struct FirstDerivatives {
    Slope G1, G2;
};
FirstDerivatives first_derivatives(const Slope& F, const Slope& Q) {
    const Slope R = sqr(F) - sqr(Q), r1 = 1 / sqrt(R), r3 = r1 / R, r5 = r3 / R, f = 1 / F;
    return {-(Q * (sqr(f) * r1 + r3)), Q * (2 * (f * sqr(f) * r1) + f * r3 + 3 * (F * r5))};
}
struct LastDerivatives {
    Interval G3, G4;
};
LastDerivatives last_derivatives(const Interval& F, const Interval& Q) {
    const Interval R = sqr(F) - sqr(Q);
    const Interval r1 = 1 / sqrt(R), r3 = r1 / R, r5 = r3 / R, r7 = r5 / R, r9 = r7 / R;
    const Interval f = 1 / F, f2 = sqr(f);
    return {-(Q * (6 * (sqr(f2) * r1) + 3 * (f2 * r3) + 15 * (sqr(F) * r7))),
            Q * (24 * (sqr(f2) * f * r1) + 12 * (f * f2 * r3) + 9 * (f * r5) - 30 * (F * r7) +
                 105 * (F * sqr(F) * r9))};
}

/// A kernel g and its derivative by Q.
struct Kernel {
    Slope (*of)(const Slope& F, const Slope& Q);
    Slope (*derivative)(const Slope& F, const Slope& Q);
    Start (*start)(const Slope& Q);
};
constexpr Kernel kernel_G{G, H, start_of_G}, kernel_H{H, H2, start_of_H};

/// K2 over x, zero included.
Interval rest_over(Slope (*g)(const Slope& F, const Slope& Q), const Interval& x, const Interval& Q) {
    const Slope F = line(x, pi<Interval>(), Interval(-1));
    return (sinc_of(Interval(1), x) * g(F, constant(Q))).second;
}
/// What Q = pi/2 + offset changes in K2 over x.
Interval moved(const Kernel& g, const Interval& x, const Interval& offset) {
    return offset * rest_over(g.derivative, x, half_pi<Interval>() + hull(Interval(0), offset));
}

/// K2(x) = at + (x - m) first + (x - m)^2 second for all x of an interval, at Q = pi/2.
struct Rest {
    Interval m, at, first, second;
};
Rest rest_near(const Kernel& g, const Interval& x) {
    const Interval Q = half_pi<Interval>(), half_turn = pi<Interval>();
    if (x.lo() < 0.002) {
        return {x, rest_over(g.of, x, Q), Interval(0), Interval(0)};
    }
    // K2 = (sin x g(pi - x) - K0 x - K1 x^2)/x^3 with slopes from m on.
    const Interval m = midpoint(x), z = x - m;
    const auto [sine, cosine] = sin_cos(m);
    const Slope sin_x =
        sine * cos_of(z) + cosine * (line(z, Interval(0), Interval(1)) * sinc_of(Interval(1), z));
    const Slope X = line(z, m, Interval(1)), F = line(z, half_turn - m, Interval(-1));
    const auto [K0, K1] = g.start(constant(Q));
    const Slope K2 = (sin_x * g.of(F, constant(Q)) - X * (K0 + K1 * X)) / (X * sqr(X));
    return {m, K2.at0, K2.first, K2.second};
}

Interval fifth(const Interval& x) { return x * sqr(sqr(x)); }

Interval rest_of(const Kernel& g, const Interval& u, const Interval& offset) {
    Interval rest = moved(g, u * Interval(0, 1), offset) / 4;
    for (int i = 0; i < rest_parts; ++i) {
        const Interval from = share(i, rest_parts), to = share(i + 1, rest_parts),
                       x = u * part(i, rest_parts);
        const Rest K2 = rest_near(g, x);
        const Interval t3 = (sqr(sqr(to)) - sqr(sqr(from))) / 4, t4 = (fifth(to) - fifth(from)) / 5;
        rest = rest + K2.at * t3 + K2.first * (u * t4 - K2.m * t3) + K2.second * sqr(x - K2.m) * t3;
    }
    return rest;
}

}  // namespace

Start start_of_G(const Slope& J) {
    const Interval half_turn = pi<Interval>();
    const Slope R = sqr(half_turn) - sqr(J), r1 = 1 / sqrt(R);
    return {J * r1 * (1 / half_turn), J * (r1 * (1 / sqr(half_turn)) + r1 / R)};
}
Start start_of_H(const Slope& Q) {
    const Interval half_turn = pi<Interval>();
    const Slope R = sqr(half_turn) - sqr(Q), r3 = 1 / (R * sqrt(R));
    return {r3 * half_turn, r3 / R * (3 * sqr(half_turn)) - r3};
}
Interval rest_of_G(const Interval& u, const Interval& offset) { return rest_of(kernel_G, u, offset); }
Interval rest_of_H(const Interval& u, const Interval& offset) { return rest_of(kernel_H, u, offset); }
Interval step_rest_of_H(const Interval& U, const Interval& rho, const Interval& offset) {
    Interval rest = moved(kernel_H, U * (1 + rho * Interval(-1, 1)), offset) * (2 + 2 * sqr(rho));
    for (int i = 0; i < step_parts; ++i) {
        // t = t0 + t', p = 1 + rho t0: int (1 + rho t)^3 dt over |t'| <= h, and the same with t'.
        const Interval h = share(1, step_parts), t0 = share(2 * i + 1 - step_parts, step_parts),
                       p = 1 + rho * t0, rh = sqr(rho * h);
        const Interval whole = 2 * h * p * (sqr(p) + rh), first = 2 * h * rho * sqr(h) * (sqr(p) + rh / 5);
        const Interval x = U * (p + rho * hull(-h, h));
        const Rest K2 = rest_near(kernel_H, x);
        rest = rest + (K2.at + K2.first * (U * p - K2.m) + K2.second * sqr(x - K2.m)) * whole +
               K2.first * U * rho * first;
    }
    return rest;
}

Interval sinc(const Interval& x) { return falling_bracket(abs(x), 0); }
Interval sinc_fall(const Interval& x) { return falling_bracket(abs(x), 1) / 6; }

Slope midpoint_error(const Interval& U, const Interval& d_per_U, const Slope& F, const Slope& Q,
                     const Slope& sin_U, const Slope& cos_U) {
    const Interval d = d_per_U * U, d2 = sqr(d), share2 = sqr(d_per_U);
    // (1/3)(1 - d^2/k [1 - d^2/l, 1])
    const auto nearly_third = [&](const Interval& over_k, const Interval& over_l) {
        const Interval fall = over_k * at_most_one(d2 * over_l);
        return one_and(U, -(share2 * fall), 1 - d2 * fall) / 3;
    };
    const Slope I2 = nearly_third(Interval(3) / 10, Interval(5) / 84);
    const Slope J1 = nearly_third(Interval(1) / 10, Interval(1) / 28);
    const Slope I4 = squared(U, share2 / 5 * at_most_one(d2 / 2));
    const Slope J3 = squared(U, share2 / 5 * at_most_one(d2 / 6));
    const auto [G1, G2] = first_derivatives(F, Q);
    const Interval around = hull(range(F) - d, range(F) + d);
    const auto [G3, G4] = last_derivatives(around, range(Q));
    return sin_U * (G2 * I2 + I4 * (G4 / 12)) - 2 * (cos_U * (G1 * J1 + J3 * (G3 / 6)));
}

Slope second_moment(const Interval& U, const Interval& f, const Slope& Q, int n) {
    Slope sum = constant(Interval(0));
    for (int i = 0; i < n; ++i) {
        const Interval ft = f * part(i, n);
        // (t1^2 - t0^2)/2 = (2i + 1)/(2n^2)
        sum = sum + sinc_of(ft, U) * H2(line(U, pi<Interval>(), -ft), Q) * share(2 * i + 1, 2 * n * n);
    }
    return sum;
}

Interval comparison_constant() {
    const Interval root = sqrt(Interval(3));
    return 1 / (3 * root * sqrt(root) * sqrt(pi<Interval>()));
}

Interval clock_constant() { return 2 * sqrt(sqrt(Interval(3)) * pi<Interval>()); }

Interval common(const Interval& x, const Interval& y) {
    if (x.is_nan() || y.is_nan() || x.hi() < y.lo() || y.hi() < x.lo()) {
        return Interval(std::numeric_limits<double>::quiet_NaN());
    }
    return {std::max(x.lo(), y.lo()), std::min(x.hi(), y.hi())};
}

}  // namespace dumbbell::law
