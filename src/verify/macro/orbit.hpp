// Polynomials that nearly follow an orbit over many collisions. Guesses: L42 takes any.
#pragma once
#include "verify/macro/series.hpp"

namespace dumbbell_verify {

/// Collision n of 0 to k is at s = 2 n/k - 1: the ray leaves it at corner distance x(s), with slope 2^-root
/// slope(s). The others are nearly sin x(s) and cos x(s).
struct Orbit {
    Series x, slope, sine, cosine;
};

/// A bound of rays after a collision, and how they are to be followed. Numbers are multiples of 2^-places.
struct Start {
    long places = 0;
    std::size_t terms = 0;  ///< of the polynomials
    long root = 0;          ///< 2^-root is about the square root of r
    mpz_class x, slope, r;  ///< the bound: x, kappa 2^root; r 2^root
    mpz_class pi;           ///< rounded
    mpz_class k;            ///< collisions, > 0
    mpz_class excess;       ///< what both expressions of L42 should be

    [[nodiscard]] Series series() const { return {terms, places}; }
};

/// The two expressions of L42, the second one times 2^root, both times k/2; on [-1, 1 - 2/k].
struct Excess {
    Series height, turn;
};
[[nodiscard]] Excess excess(const Orbit& orbit, const Start& start);

/// False if no orbit was found.
[[nodiscard]] bool guess_orbit(const Start& start, Orbit& orbit);

}  // namespace dumbbell_verify
