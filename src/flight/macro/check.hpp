#pragma once

#include "base/interrupted.hpp"
#include "flight/macro/ball.hpp"
#include "flight/macro/macro_step.hpp"

/// Macro steps (lemma L42): what polynomials must satisfy, for a bound of rays to move along them.
namespace dumbbell::flight::macro {

/// The number n of collisions runs over [a, a + collisions], s = 2 (n - a)/collisions - 1 over [-1, 1].
/// After collision n the ray has left the wall at corner distance x(s), with slope kappa(s).
struct Orbit {
    Series x;
    Series kappa;
    Series sine;    ///< nearly sin x(s)
    Series cosine;  ///< nearly cos x(s)
};

/// What an orbit is wanted for.
struct Task {
    Ball r;                           ///< 1/q
    Ball x, kappa;                    ///< the state at s = -1
    Count collisions{};               ///< how many
    slong terms = 0;                  ///< of the polynomials
    Ball x_excess, kappa_excess;      ///< wanted of both sides of L42 (6), (7), times collisions/2
    Interrupted interrupted = never;  ///< asked for each coefficient: EndedEarly is thrown
};

/// The two expressions of L42, times collisions/2, to `length` terms.
struct Excess {
    Series height;  ///< sin x(s + eta) - sin x - kappa (x + x(s + eta) + pi)
    Series slope;  ///< (kappa(s + eta) - kappa)(w^2 - r) - 2 w (r + kappa kappa(s + eta)), w = cos x(s + eta)
};
/// Bounds on [-1, 1] of the sizes of sine - sin x and cosine - cos x, and of their derivatives; 0 for a
/// guess.
struct SineError {
    Ball value, slope;
};
[[nodiscard]] Excess excess(const Orbit& orbit, const Task& task, slong length, const SineError& error);

/// Certified: the polynomials satisfy L42 (a) for `upper`, (b) for `lower`. That they begin at a bound of the
/// state is the caller's business.
[[nodiscard]] bool is_macro_step(BoundSide side, const Orbit& orbit, const Task& task);

}  // namespace dumbbell::flight::macro
