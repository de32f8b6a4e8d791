#pragma once

#include <optional>
#include <vector>

#include "collisions/claim.hpp"
#include "critical/enclose.hpp"

/// Where N of bodies steps (Theorem B of body.md).
namespace dumbbell::critical {

/// A curve of bodies, each by a number t > 0: with one rho by its Q, along which N does not decrease (L83);
/// or dumbbells of one mass ratio by the mass of their rod, of which nothing like that is known.
struct Bodies {
    Rational number;  ///< rho, or the mass ratio
    bool have_rods = false;

    [[nodiscard]] collisions::Claim at(const Rational& t) const;
    /// N that all of them have at least with one rho: 1 + 2 k0 of Theorem B.
    [[nodiscard]] long least() const { return number < 1 ? 3 : 2; }
};

/// The step to n with one rho: N < n iff Q <= Q_c, q_lo <= Q_c <= q_hi. N is `below` < n at q_lo, and at q_hi
/// the enclosure's n, which may be greater than this one, each proved by a bound of orbits (L87) and by
/// a witness (L74). Nothing if interrupted, or if no precision proves so many digits. Precondition: n >
/// least().
[[nodiscard]] std::optional<Ratio> enclose_inertia(const Bodies& bodies, long n, const Options& options);

/// Falls of N with the mass of the rod, each proved like that: from n at q_lo to `below` at q_hi. The last
/// row has no ratio if what follows was not enclosed. The masses are tried by factors of 2.
[[nodiscard]] std::vector<Row> enclose_falls(const Bodies& bodies, const Options& options);

}  // namespace dumbbell::critical
