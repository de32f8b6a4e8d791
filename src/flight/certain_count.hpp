#pragma once

#include "flight/plain.hpp"

/// Counting forward what certainly happens to every state of an enclosure (lemma L74): the witnesses of
/// bodies.
namespace dumbbell::flight {

/// The contact of a body with the bridge at corner distance e, with the steepness eta of the outgoing ray X
/// over the bridge's tangent: X, and the reversed incoming ray sigma X. Precondition: 0 < e < pi/2, eta > 0.
template <class I>
struct ContactRays {
    PlainRay<I> outgoing, reversed;
};

template <class I>
ContactRays<I> contact_rays(const I& e, const I& eta, const Body<I>& body) {
    const SinCos<I> at = sin_cos(e);
    const I up = at.cos + eta;
    const I down = reversed_steepness(eta, at.cos, body.rho / body.g) - at.cos;  // Q rho^2 = rho / g
    return {{body.rho * (at.sin + up * (pi<I>() - e)), body.rho * up},
            {body.rho * (at.sin + down * e), body.rho * down}};
}

template <class I>
long certain_later_collisions(PlainDeparture<I> from, const Body<I>& body, long target);

/// A number of collisions that every ray certainly has, at most `target`.
template <class I>
long certain_count(PlainRay<I> ray, const Body<I>& body, long target) {
    ray.c = max(I(0), ray.c);
    if (target <= 0 || !highest_contact(high_end(ray.c), high_end(ray.kappa))) {
        return 0;
    }
    PlainDeparture<I> next;
    const bool return_all =
        target > 1 && detail::plain_collision(ray, body.r, next) == detail::Onward::return_all;
    return 1 + (return_all ? certain_later_collisions(next, body, target - 1) : 0);
}

/// The same of departures from R to the left.
template <class I>
long certain_later_collisions(PlainDeparture<I> from, const Body<I>& body, long target) {
    const BridgeApproach<I> over_corner{max(I(0), from.sin_x + from.kappa * from.x), from.kappa};
    if (certainly_clears_bridge(low_end(over_corner.height), low_end(from.kappa), high_end(body.rho))) {
        const PlainRay<I> ray = detail::past_bridge(from);
        return certainly_positive(ray.c) ? certain_count(ray, body, target)
                                         : 0;  // else perhaps into the corner
    }
    const RatioRange<I> heights{low_end(body.rho), high_end(body.rho)};
    const BridgeApproach<I> highest{high_end(over_corner.height), high_end(from.kappa)};
    const I latest = latest_bridge_contact(highest, low_end(from.kappa), heights);
    if (target <= 0 || !certainly_below_bridge(highest, latest, heights.r_lo)) {
        return 0;
    }
    const I t = detail::bridge_contacts(over_corner, latest, body.rho);
    const auto rays = detail::off_bridge(t, from.kappa, body);
    if (rays.undecided || rays.left.has_value() == rays.right.has_value()) {
        return 1;
    }
    return 1 + certain_count(rays.left ? *rays.left : *rays.right, body, target - 1);
}

}  // namespace dumbbell::flight
