#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include "rooms/flight/reference.hpp"

/// The quantities of proofs/law.md evaluated directly, in 60 digits: the clock by quadrature, a step by the
/// law of reflection, nothing expanded and nothing divided out.
namespace dumbbell_test {

inline bool contains(const dumbbell::Interval& x, const Real& value) {
    return x.lo() <= value && value <= x.hi();
}

template <class Function>
Real integrate(const Function& f, const Real& a, const Real& b) {
    constexpr int parts = 8;
    Real sum = 0;
    for (int i = 0; i < parts; ++i) {
        sum += boost::math::quadrature::gauss<Real, 30>::integrate(f, Real(a + (b - a) * i / parts),
                                                                   Real(a + (b - a) * (i + 1) / parts));
    }
    return sum;
}

/// tau(u, J), for small u by its form in x, else by the one in alpha.
inline Real clock_by_place(const Real& u, const Real& J) {
    return integrate(
        [&](const Real& x) {
            const Real F = pi_in<Real>() - x;
            return Real(sin(x) * J / (F * sqrt(F * F - J * J)));
        },
        0, u);
}
inline Real clock_by_angle(const Real& alpha, const Real& J) {
    return integrate([&](const Real& a) { return Real(sin(J / cos(a))); }, alpha, acos(J / pi_in<Real>()));
}

/// Mid-kick states before and after a step, from its coordinates: mid-point U, half width d, and Q = F cos
/// th.
struct DirectStep {
    Real eps, th, u, u2, alpha, alpha2, J, J2, Q;

    DirectStep(const Real& U, const Real& d, const Real& with_Q) : u(U + d), u2(U - d), Q(with_Q) {
        const Real F = pi_in<Real>() - U;
        th = acos(Q / F);
        eps = sin(d) * sin(U) / (tan(th) * F);
        alpha = th - atan(eps / sin(u));
        alpha2 = th + atan(eps / sin(u2));
        J = (pi_in<Real>() - u) * cos(alpha);
        J2 = (pi_in<Real>() - u2) * cos(alpha2);
    }
};

/// The step whose J is pi/2 - share * eps^2/u^3.
inline DirectStep step_with(const Real& U, const Real& d, const Real& share) {
    const Real half = pi_in<Real>() / 2;
    DirectStep step(U, d, half);
    for (int i = 0; i < 60; ++i) {
        const Real wanted = half - share * step.eps * step.eps / (step.u * step.u * step.u);
        step = DirectStep(U, d, step.Q + wanted - step.J);
    }
    return step;
}

/// k0 s (sqrt T - sqrt(T - 1))^3.
inline Real comparison(const Real& eps, const Real& T) {
    const Real k0 = 1 / (pow(Real(3), Real(7) / 4) * sqrt(pi_in<Real>()));
    const Real root = sqrt(T) - sqrt(T - 1);
    return k0 * sqrt(eps) * root * root * root;
}

}  // namespace dumbbell_test
