#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "flight/reflection.hpp"
#include "number/rational.hpp"

/// The straight wedge yhat = |psi| - pi/2: it has no scale, a flight collides iff its slope is below 1, and a
/// slope changes by L4 with w = 1 (lemma L17).
namespace dumbbell::flight {

/// The number of later collisions of a ray of slope kappa at mass ratio 1/r, exactly; nothing if interrupted.
/// Stops at `cap` + 1. Does not increase with kappa or r.
[[nodiscard]] inline std::optional<long> wedge_count(Rational kappa, const Rational& r, long cap,
                                                     const Interrupted& interrupted = never) {
    for (long count = 0; count <= cap; ++count) {
        if (kappa >= 1) {
            return count;
        }
        const auto out = LightReflection<Rational>{kappa + r * (2 - kappa), 1 - 2 * kappa - r};
        if (out.denominator <= 0) {
            return count + 1;
        }
        if (interrupted()) {  // each step is longer than the one before
            return std::nullopt;
        }
        kappa = out.numerator / out.denominator;
    }
    return cap + 1;
}

/// The same for all rays at or above `kappa` and `r`, with outward rounded lower bounds: fast, but blind to
/// exact ties; `cap` + 1 if interrupted.
template <class I>
[[nodiscard]] long wedge_count_at_most(I kappa, const I& r, long cap,
                                       const Interrupted& interrupted = never) {
    const I least_r = low_end(r);
    for (long count = 0; count <= cap; ++count) {
        kappa = low_end(kappa);
        if (certainly_at_most(I(1), kappa)) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, I(1), least_r);
        if (certainly_at_most(out.denominator, I(0))) {
            return count + 1;
        }
        if (!certainly_positive(out.denominator) || ends_early(count, interrupted)) {
            return cap + 1;
        }
        kappa = out.numerator / out.denominator;
    }
    return cap + 1;
}

}  // namespace dumbbell::flight
