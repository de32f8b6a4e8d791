#pragma once

#include <algorithm>

#include "flight/bridge_contact.hpp"
#include "flight/chart.hpp"
#include "flight/contact.hpp"
#include "flight/count.hpp"

/// Counting forward from a box of departures from a light wall, in any direction, from its lowest and its
/// highest corner (lemma L15).
namespace dumbbell::flight {

/// One departure from a light wall: corner distance x with its sine and cosine, and slope kappa (negative:
/// descending).
template <class I>
struct Departure {
    I x;
    I sin_x;
    I cos_x;
    I kappa;
};

/// Chart departure: the ray that leaves R at the position with slope eta above the wall's tangent, kappa =
/// eta - cos e.
template <class I>
Departure<I> departure(const Position<I>& at, const I& eta) {
    return {at.e, at.sin_e, at.cos_e, eta - at.cos_e};
}

/// The lower and the upper ends of both coordinates: the lowest and the highest ray.
template <class I>
Departure<I> lowest(const Departure<I>& d) {
    return {low_end(d.x), low_end(d.sin_x), high_end(d.cos_x), low_end(d.kappa)};
}
template <class I>
Departure<I> highest(const Departure<I>& d) {
    return {high_end(d.x), high_end(d.sin_x), low_end(d.cos_x), high_end(d.kappa)};
}

namespace detail {

/// The highest ray after the flight that ends at `contact`; where not even its collision is certain, x <=
/// pi/2, w > kappa and kappa' < 1 still hold for those that collide and return.
template <class I>
Departure<I> highest_after(const std::optional<Contact<I>>& contact, const Departure<I>& low,
                           const Departure<I>& high, const I& r) {
    const Contact<I> at = contact ? *contact : Contact<I>{high_end(half_pi<I>()), I(1), max(I(0), low.kappa)};
    const auto out = reflect_at_light_wall(high.kappa, at.cos_x, r);
    const I steepest =
        certainly_positive(out.denominator) ? min(I(1), high_end(out.numerator / out.denominator)) : I(1);
    return {at.x, at.sin_x, at.cos_x, contact ? steepest : max(I(0), steepest)};
}

}  // namespace detail

/// An upper bound of the number of later collisions over all departures between `low` and `high` and all
/// ratios of the range. Stops at `cap` + 1, also if interrupted. Precondition: the departures are outgoing,
/// kappa > -cos x.
template <class I>
long later_collisions_at_most(Departure<I> low, Departure<I> high, const RatioRange<I>& range, long cap,
                              const Interrupted& interrupted = never) {
    const I r_lo = low_end(range.r_lo);
    const I r_hi = high_end(range.r_hi);
    long most = 0;
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), low.kappa)) {
            return std::max(most, count);  // L3
        }
        const I c_low = low_end(max(I(0), low.sin_x + low.kappa * (low.x + pi<I>())));
        if (certainly_at_most(r_hi, low.kappa)) {
            // From here on every slope is at least r: the bridge is out of reach (L6).
            const long later =
                as_long(count_at_most(Ray<I>{c_low, low.kappa, r_lo}, cap - count, interrupted));
            return std::max(most, count + later);
        }
        const I over_corner = low_end(low.sin_x + low.kappa * low.x);
        if (!certainly_clears_bridge(over_corner, low.kappa, r_hi)) {
            const BridgeApproach<I> highest_ray{high_end(high.sin_x + high.kappa * high.x), high.kappa};
            const I latest = latest_bridge_contact(highest_ray, low.kappa, range);
            const long later =
                as_long(count_at_most(lowest_over(bridge_tangent(latest), range), cap - count, interrupted));
            most = std::max(most, count + 1 + later);
            if (most > cap || certainly_below_bridge(highest_ray, latest, r_lo)) {
                return most;
            }
        }
        const auto least = lowest_contact(c_low, low.kappa);
        if (!least) {
            return std::max(most, count);
        }
        const I c_high = high_end(high.sin_x + high.kappa * (high.x + pi<I>()));
        high = detail::highest_after(highest_contact(c_high, high.kappa), low, high, r_hi);
        const auto out = reflect_at_light_wall(low.kappa, least->cos_x, r_lo);
        if (certainly_at_most(out.denominator, I(0))) {
            return std::max(most, count + 1);  // L1: all leave the cell
        }
        if (!certainly_positive(out.denominator)) {
            return cap + 1;  // cannot tell whether the lowest ray returns
        }
        if (ends_early(count, interrupted)) {
            return cap + 1;
        }
        low = {least->x, least->sin_x, least->cos_x, low_end(out.numerator / out.denominator)};
    }
    return cap + 1;
}

}  // namespace dumbbell::flight
