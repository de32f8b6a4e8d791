// Macro steps (L42): what polynomials must satisfy, for a bound of rays to move along them.
#pragma once
#include "verify/macro/series.hpp"

namespace dumbbell_verify {

/// Collision n of 0 to k is at s = 2 n/k - 1: the ray leaves it at corner distance x(s), with slope 2^-root
/// slope(s). The others are nearly sin x(s) and cos x(s).
struct Orbit {
    Series x, slope, sine, cosine;
    mpz_class sine_slope_error = 0;  ///< of sine' as the derivative of sin x
};

/// A bound of rays after a collision, and how they are to be followed. Numbers are multiples of 2^-places.
struct Start {
    long places = 0;
    std::size_t terms = 0;  ///< of the polynomials
    long root = 0;          ///< 2^-root is about the square root of r
    mpz_class x, slope, r;  ///< the bound: x, kappa 2^root; r 4^root
    mpz_class pi;           ///< rounded
    mpz_class k;            ///< collisions, > 0
    mpz_class excess;       ///< what both expressions of L42 should be

    [[nodiscard]] Series series() const { return {terms, places}; }
    [[nodiscard]] Orbit orbit() const { return {series(), series(), series(), series()}; }
};

/// The two expressions of L42, the second one times 2^root, both times k/2; on [-1, 1 - 2/k].
struct Excess {
    Series height, turn;
};
[[nodiscard]] Excess excess(const Orbit& orbit, const Start& start);

/// Certified that the polynomials begin at x and slope and satisfy L42: (a) for `up`, (b) for `down`.
/// Precondition: k > 0, x >= 0, slope > 0.
[[nodiscard]] bool is_macro_step(Round d, Orbit orbit, const Start& start);

/// x as a multiple of 2^-places, rounded.
[[nodiscard]] mpz_class fixed(Round d, const mpq_class& x, long places);

/// Gives the thread its precision back.
class PrecisionKept {
  public:
    PrecisionKept();
    PrecisionKept(const PrecisionKept&) = delete;
    PrecisionKept& operator=(const PrecisionKept&) = delete;
    ~PrecisionKept();

  private:
    long before_;
};

}  // namespace dumbbell_verify
