#pragma once

#include "attacks/oracle/law.hpp"
#include "number/interval.hpp"

/// Steps in 80 digits, as proofs/law.md defines them (tests/attacks/oracle): nothing expanded and nothing
/// divided out.
namespace dumbbell_test {

using Real = dumbbell_oracle::Digits80;
using DirectStep = dumbbell_oracle::law::Step<Real>;
using dumbbell_oracle::law::comparison, dumbbell_oracle::law::k0, dumbbell_oracle::law::tau,
    dumbbell_oracle::law::tau_by_angle;

inline bool contains(const dumbbell::Interval& x, const Real& value) {
    return x.lo() <= value && value <= x.hi();
}

/// The step of middle U and half width rho U whose J is pi/2 - share * eps^2/u^3.
inline DirectStep step_with(const Real& U, const Real& rho, const Real& share) {
    const Real half = dumbbell_oracle::pi<Real>() / 2;
    DirectStep step(U, rho, half);
    for (int i = 0; i < 60; ++i) {
        const Real wanted = half - share * step.eps * step.eps / (step.u * step.u * step.u);
        step = DirectStep(U, rho, step.Q + wanted - step.j);
    }
    return step;
}

}  // namespace dumbbell_test
