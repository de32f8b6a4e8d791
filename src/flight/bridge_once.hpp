#pragma once

#include "flight/chart.hpp"
#include "number/elementary.hpp"

/// The heavy mass touches the floor at most once (lemma L19).
namespace dumbbell::flight {

/// Certified: of all rays that leave the bridge at a position up to `t` (from the right corner, radians) with
/// a steepness in `eta` (their slope is r (cos t + eta), eta >= 0), those that come back from the next light
/// wall do so with a slope of at least r, and are above the bridge from then on.
template <class I>
[[nodiscard]] bool certainly_once(const I& t, const I& eta, const RatioRange<I>& range) {
    // 1 + lambda = 1 + cos t + eta, where 1 + cos t falls from 2 to 0.
    const I least = max(I(0), I(1) + sin_cos(min(high_end(t), pi<I>())).cos) + low_end(eta);
    const I greatest = I(2) + high_end(eta);
    const I r_lo = low_end(range.r_lo);
    const I r_hi = high_end(range.r_hi);
    const I lambda = low_end(least - I(1));
    const I kappa = low_end(min(r_lo * lambda, r_hi * lambda));
    if (certainly_at_most(I(1), kappa)) {
        return true;  // L3
    }
    // D > 0 needs w > kappa + sqrt(kappa^2 + r), which grows with kappa and r.
    const I w = max(I(0), low_end(kappa + sqrt(sqr(kappa) + r_lo)));
    const I first = w * (w + I(2) * r_lo) - r_hi;
    return certainly_at_most(I(0), first) ||
           certainly_at_most(I(0), high_end(greatest) * first + (w + r_lo) / I(2));
}

}  // namespace dumbbell::flight
