#pragma once

#include <optional>

#include "collisions/section.hpp"
#include "flight/corner.hpp"
#include "flight/valley.hpp"

/// The two tangents of the bridge, and what is looked for by them (Theorem B of body.md).
namespace dumbbell::collisions {

/// One body, as its counts need it; rho and r enclose it.
template <class I>
class Tangents {
  public:
    Tangents(const Rational& rho, const Rational& q, const Interrupted& interrupted)
        : rho_(enclose<I>(rho)), r_(enclose<I>(1 / q)), is_symmetric_(rho == 1), interrupted_(interrupted) {}

    /// Upper bounds of f(e) and b(e), of k1 and J at e = 0, each at most cap + 1 (L81, L82).
    [[nodiscard]] long upward(const I& e, long cap) const {
        return is_symmetric_                     ? 0  // over the top all is as high as the peaks
               : certainly_less(e, half_pi<I>()) ? count(flight::tangent_upward(e, rho_, r_), cap)
                                                 : count({low_end(rho_), I(0), low_end(r_)}, cap);
    }
    [[nodiscard]] long into_valley(const I& e, long cap) const {
        return flight::valley_hits_at_most(flight::tangent_into_valley(e, rho_, r_), rho_, cap, interrupted_);
    }
    /// The same of T if J is `hits`.
    [[nodiscard]] long even(long hits, long cap) const {
        return flight::even_at_most(hits, rho_, r_, cap, interrupted_);
    }

  private:
    [[nodiscard]] long count(const flight::Ray<I>& ray, long cap) const {
        return as_long(count_at_most(ray, cap, interrupted_));
    }

    I rho_, r_;
    bool is_symmetric_;
    const Interrupted& interrupted_;
};

/// Whether ceil(pi/corner) >= n, exactly where that is not too long; else true.
[[nodiscard]] inline bool may_have_in_corner(long n, const Rational& rho, const Rational& q) {
    return n > most_in_corner || flight::corner_count(rho, q, n) >= n;
}

/// J from above, and exactly where the corner's count is not too long: beside a tie no precision tells it.
template <class I>
[[nodiscard]] long corner_hits(const Tangents<I>& of, const Rational& rho, const Rational& q, long cap) {
    const long hits = of.into_valley(I(0), cap);
    return may_have_in_corner(2 * hits + 1, rho, q) ? hits
                                                    : (flight::corner_count(rho, q, 2 * hits + 1) - 1) / 2;
}

/// What seems to be N of a body (tangent_search.cpp); nothing if interrupted.
template <class I>
[[nodiscard]] std::optional<Count> body_maximum(const Rational& q, const System& system,
                                                const Interrupted& interrupted);
/// A witness in the corner (L73), or at the bridge.
template <class I>
[[nodiscard]] std::optional<Witness> body_witness(const Range& range, const Count& wanted,
                                                  const System& system, const Interrupted& interrupted);

}  // namespace dumbbell::collisions
