#pragma once

#include <algorithm>
#include <optional>

#include "base/interrupted.hpp"
#include "flight/bridge_contact.hpp"
#include "flight/contact.hpp"
#include "flight/reflection.hpp"
#include "number/enclosure.hpp"

/// Counting forward by plain interval evaluation (lemma L16): every formula is evaluated over the whole box,
/// none is known to be monotone. Rests on L1, L3, L4, and of L6 on "B at most once"; of bodies with mass
/// between their contacts on L71.
namespace dumbbell::flight {

/// All rays with these heights and slopes on their way to a light wall.
template <class I>
struct PlainRay {
    I c;
    I kappa;
};

/// All departures from a light wall with these corner distances, heights and slopes.
template <class I>
struct PlainDeparture {
    I x;
    I sin_x;
    I kappa;
};

namespace detail {

/// The part of the slopes that is in play, kappa <= 1.
template <class I>
I in_play(const I& kappa) {
    const I lo = low_end(kappa);
    return certainly_less(lo, I(1)) ? hull(lo, min(high_end(kappa), I(1))) : lo;
}

/// numerator / denominator, where the denominator's positive part is meant and the numerator is positive if
/// the denominator may be 0; slopes above 1 are cut off. `undecided` is set if nothing can be said.
template <class I>
I slope_of(const I& numerator, const I& denominator, bool& undecided) {
    if (certainly_positive(denominator)) {
        return in_play(numerator / denominator);
    }
    undecided = !certainly_positive(numerator);
    return undecided ? I(0) : in_play(hull(low_end(numerator) / high_end(denominator), I(2)));
}

/// kappa' of L4 over a box. With A = (w - r/w)/2 it is also (A^2 + r)/(A - kappa) - A, where kappa stands
/// once, and kappa + (r + kappa^2)/(A - kappa), where A stands once: the common part of all three.
template <class I>
I reflected_slope(const LightReflection<I>& out, const I& kappa, const I& w, const I& r, bool& undecided) {
    I plain = slope_of(out.numerator, out.denominator, undecided);
    if (undecided || !certainly_positive(out.denominator) || !certainly_positive(w)) {
        return plain;
    }
    const I a = (w - r / w) / I(2);
    if (!certainly_positive(a - kappa)) {
        return plain;
    }
    const I kappa_once = in_play((sqr(a) + r) / (a - kappa) - a);
    const I a_once = in_play(kappa + (r + sqr(kappa)) / (a - kappa));
    return intersection(intersection(plain, kappa_once), a_once);
}

/// Encloses the contacts of those rays that collide, in [0, pi/2]; nothing if none does.
template <class I>
std::optional<Contact<I>> plain_contact(const PlainRay<I>& ray) {
    const auto least = lowest_contact(low_end(ray.c), low_end(ray.kappa));
    if (!least) {
        return std::nullopt;
    }
    const auto greatest = highest_contact(high_end(ray.c), high_end(ray.kappa), approximate(least->x));
    if (!greatest) {
        return Contact<I>{hull(least->x, half_pi<I>()), hull(least->sin_x, I(1)),
                          hull(max(I(0), low_end(ray.kappa)), least->cos_x)};
    }
    return Contact<I>{hull(least->x, greatest->x), hull(least->sin_x, greatest->sin_x),
                      hull(greatest->cos_x, least->cos_x)};
}

/// What becomes of rays to a light wall.
enum class Onward { misses, leaves, may_return, return_all, undecided };

/// Their collision, if any. `next`: the departures of those that return after it.
template <class I>
Onward plain_collision(const PlainRay<I>& ray, const I& r, PlainDeparture<I>& next) {
    const auto at = plain_contact(ray);
    if (!at) {
        return Onward::misses;
    }
    const auto out = reflect_at_light_wall(ray.kappa, at->cos_x, r);
    if (certainly_at_most(out.denominator, I(0))) {
        return Onward::leaves;
    }
    bool undecided = false;
    next = {at->x, at->sin_x, reflected_slope(out, ray.kappa, at->cos_x, r, undecided)};
    return undecided                             ? Onward::undecided
           : certainly_positive(out.denominator) ? Onward::return_all
                                                 : Onward::may_return;
}

/// The later collisions in all, if this one ends them, after `count` others; nothing is known of the
/// undecided.
inline std::optional<long> ended(Onward onward, long count, long cap) {
    switch (onward) {
        case Onward::misses:
            return count;
        case Onward::leaves:
            return count + 1;
        case Onward::undecided:
            return cap + 1;
        default:
            return std::nullopt;
    }
}

/// The rays that departures are when they do not meet the bridge.
template <class I>
PlainRay<I> past_bridge(const PlainDeparture<I>& from) {
    return {from.sin_x + from.kappa * (from.x + pi<I>()), from.kappa};
}

}  // namespace detail

template <class I>
long plain_later_collisions(PlainDeparture<I> from, const Body<I>& body, long cap,
                            const Interrupted& interrupted = never);

/// An upper bound of the number of collisions of rays that have no bridge before the next light wall. Stops
/// at `cap` + 1, also if interrupted.
template <class I>
long plain_count(PlainRay<I> ray, const Body<I>& body, long cap, const Interrupted& interrupted = never) {
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), ray.kappa)) {
            return count;
        }
        ray.c = max(I(0), ray.c);
        PlainDeparture<I> next;
        if (const auto total = detail::ended(detail::plain_collision(ray, body.r, next), count, cap)) {
            return *total;
        }
        if (ends_early(count, interrupted)) {
            return cap + 1;
        }
        if (!body.is_massless) {
            // It may come back to the bridge, and branch there again and again; of dumbbells none does (L6
            // (c)).
            const bool ends = count == cap || interrupted();
            return ends ? cap + 1 : 1 + plain_later_collisions(next, body, cap - 1, interrupted);
        }
        ray = detail::past_bridge(next);
    }
    return cap + 1;
}

namespace detail {

/// An enclosure of the t of first contact with the bridge.
template <class I>
I bridge_contacts(const BridgeApproach<I>& ray, const I& latest, const I& rho) {
    // f(t) = height + kappa t - rho sin t of the lowest ray is convex: f > 0 and f' < 0 prove that no contact
    // comes before.
    const double t =
        guess_bridge_contact(low_end(ray.height).lo(), low_end(ray.kappa).lo(), high_end(rho).hi());
    const I early(std::max(0.0, t * (1 - 1e-9) - 1e-12));
    const SinCos<I> at = sin_cos(early);
    const bool proved =
        certainly_less(early, latest) &&
        certainly_less(high_end(rho) * at.sin, low_end(ray.height) + low_end(ray.kappa) * early) &&
        certainly_less(low_end(ray.kappa), low_end(rho * at.cos));
    return hull(proved ? early : I(0), latest);
}

/// The rays that leave the bridge, after a contact at t in T of rays of slope kappa: to the left and to the
/// right, in either case only if there may be some.
template <class I>
struct OffBridge {
    std::optional<PlainRay<I>> left, right;
    bool undecided = false;  ///< nothing is known of those of a direction
};

template <class I>
OffBridge<I> off_bridge(const I& t, const I& kappa, const Body<I>& body) {
    const SinCos<I> at = sin_cos(t);
    const auto [numerator, leftward] = reflect_at_end(End::heavy, kappa, at.cos, body);
    OffBridge<I> rays;
    if (!certainly_at_most(leftward, I(0))) {
        const I slope = slope_of(numerator, leftward, rays.undecided);
        rays.left = PlainRay<I>{body.rho * at.sin + slope * (pi<I>() - t), slope};
    }
    if (!certainly_positive(leftward) && !rays.undecided) {
        const I slope = slope_of(numerator, -leftward, rays.undecided);
        rays.right = PlainRay<I>{body.rho * at.sin + slope * t, slope};
    }
    return rays;
}

/// Their later collisions.
template <class I>
long plain_count_after_bridge(const I& t, const I& kappa, const Body<I>& body, long cap,
                              const Interrupted& interrupted) {
    const OffBridge<I> rays = off_bridge(t, kappa, body);
    long most = rays.undecided || cap < 0 ? cap + 1 : 0;
    for (const auto& ray : {rays.left, rays.right}) {
        if (ray && most <= cap) {
            most = std::max(most, plain_count(*ray, body, cap, interrupted));
        }
    }
    return most;
}

}  // namespace detail

/// An upper bound of the number of later collisions of the departures from R to the left. Stops at `cap` + 1,
/// also if interrupted.
template <class I>
long plain_later_collisions(PlainDeparture<I> from, const Body<I>& body, long cap,
                            const Interrupted& interrupted) {
    const RatioRange<I> heights{low_end(body.rho), high_end(body.rho)};
    long most = 0;
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), from.kappa)) {
            return std::max(most, count);
        }
        const BridgeApproach<I> over_corner{max(I(0), from.sin_x + from.kappa * from.x), from.kappa};
        if (!certainly_clears_bridge(low_end(over_corner.height), low_end(from.kappa), heights.r_hi)) {
            const BridgeApproach<I> highest{high_end(over_corner.height), high_end(from.kappa)};
            const I latest = latest_bridge_contact(highest, low_end(from.kappa), heights);
            const I t = detail::bridge_contacts(over_corner, latest, body.rho);
            most = std::max(most, count + 1 +
                                      detail::plain_count_after_bridge(t, from.kappa, body, cap - count - 1,
                                                                       interrupted));
            if (most > cap || certainly_below_bridge(highest, latest, heights.r_lo)) {
                return most;
            }
        }
        PlainRay<I> ray = detail::past_bridge(from);
        ray.c = max(I(0), ray.c);
        if (const auto total = detail::ended(detail::plain_collision(ray, body.r, from), count, cap)) {
            return std::max(most, *total);
        }
        if (ends_early(count, interrupted)) {
            return cap + 1;
        }
    }
    return cap + 1;
}

}  // namespace dumbbell::flight
