#pragma once

#include <optional>

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

namespace detail {

/// Enclosures of the t at which all of these flights from R hit the bridge, certainly; else nothing.
template <class I>
std::optional<I> certain_bridge_contacts(const BridgeApproach<I>& ray, const I& kappa_lo, const I& rho) {
    // In units of rho it is a light wall's hump: up to its top as many bits tell as there are.
    const I height = ray.height / rho, kappa = ray.kappa / rho;
    if (const auto last = highest_contact(high_end(height), high_end(kappa))) {
        const auto first = lowest_contact(low_end(height), low_end(kappa), approximate(last->x));
        return hull(first ? first->x : I(0), last->x);
    }
    const RatioRange<I> heights{low_end(rho), high_end(rho)};
    const BridgeApproach<I> highest{high_end(ray.height), high_end(ray.kappa)};
    const I latest = latest_bridge_contact(highest, kappa_lo, heights);
    return certainly_below_bridge(highest, latest, heights.r_lo)
               ? std::optional(bridge_contacts(ray, latest, rho))
               : std::nullopt;
}

/// The way of departures from R to the left on to a light wall, where all take the same; `count` grows by the
/// contact with the bridge, if there is one.
template <class I>
std::optional<PlainRay<I>> certain_way(const PlainDeparture<I>& from, const Body<I>& body, long& count) {
    const BridgeApproach<I> over_corner{max(I(0), from.sin_x + from.kappa * from.x), from.kappa};
    const I kappa_lo = low_end(from.kappa);
    if (certainly_clears_bridge(low_end(over_corner.height), kappa_lo, high_end(body.rho))) {
        const PlainRay<I> ray = past_bridge(from);
        return certainly_positive(ray.c) ? std::optional(ray) : std::nullopt;  // else perhaps into the corner
    }
    const auto t = certain_bridge_contacts(over_corner, kappa_lo, body.rho);
    if (!t) {
        return std::nullopt;
    }
    ++count;
    const auto rays = off_bridge(*t, from.kappa, body);
    return rays.undecided || rays.left.has_value() == rays.right.has_value() ? std::nullopt
           : rays.left                                                       ? rays.left
                                                                             : rays.right;
}

}  // namespace detail

/// A number of collisions that every ray certainly has, at most `target`.
template <class I>
long certain_count(const PlainRay<I>& first, const Body<I>& body, long target) {
    long count = 0;
    for (std::optional ray = first; ray && count < target;) {
        ray->c = max(I(0), ray->c);
        if (!highest_contact(high_end(ray->c), high_end(ray->kappa))) {
            break;
        }
        PlainDeparture<I> next;
        const bool return_all =
            ++count < target && detail::plain_collision(*ray, body.r, next) == detail::Onward::return_all;
        ray = return_all ? detail::certain_way(next, body, count) : std::nullopt;
    }
    return count;
}

/// The same of departures from R to the left.
template <class I>
long certain_later_collisions(const PlainDeparture<I>& from, const Body<I>& body, long target) {
    long count = 0;
    const auto ray = target > 0 ? detail::certain_way(from, body, count) : std::nullopt;
    return ray ? count + certain_count(*ray, body, target - count) : count;
}

}  // namespace dumbbell::flight
