#pragma once

#include <algorithm>

#include "base/interrupted.hpp"
#include "flight/bridge_contact.hpp"
#include "flight/contact.hpp"
#include "flight/reflection.hpp"
#include "number/enclosure.hpp"

/// Counting forward by plain interval evaluation (lemma L16): every formula is evaluated over the whole box,
/// none is known to be monotone. Rests on L1, L3, L4, and of L6 on "B at most once".
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

/// The contacts of those rays that collide, and whether they may return; `x` in [0, pi/2].
template <class I>
struct PlainContact {
    I x;
    I sin_x;
    I cos_x;
};

template <class I>
std::optional<PlainContact<I>> plain_contact(const PlainRay<I>& ray) {
    const auto least = lowest_contact(low_end(ray.c), low_end(ray.kappa));
    if (!least) {
        return std::nullopt;
    }
    const auto greatest = highest_contact(high_end(ray.c), high_end(ray.kappa), approximate(least->x));
    if (!greatest) {
        return PlainContact<I>{hull(least->x, half_pi<I>()), hull(least->sin_x, I(1)),
                               hull(max(I(0), low_end(ray.kappa)), least->cos_x)};
    }
    return PlainContact<I>{hull(least->x, greatest->x), hull(least->sin_x, greatest->sin_x),
                           hull(greatest->cos_x, least->cos_x)};
}

}  // namespace detail

/// An upper bound of the number of collisions of the rays with the light walls, the bridge out of reach.
/// Stops at `cap` + 1, also if interrupted. Flattened, as the other one: intervals stay in registers.
template <class I>
[[gnu::flatten]] long plain_count(PlainRay<I> ray, const I& r, long cap,
                                  const Interrupted& interrupted = never) {
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), ray.kappa)) {
            return count;
        }
        ray.c = max(I(0), ray.c);
        const auto at = detail::plain_contact(ray);
        if (!at) {
            return count;
        }
        const auto out = reflect_at_light_wall(ray.kappa, at->cos_x, r);
        if (certainly_at_most(out.denominator, I(0))) {
            return count + 1;
        }
        bool undecided = false;
        ray.kappa = detail::reflected_slope(out, ray.kappa, at->cos_x, r, undecided);
        if (undecided || ends_early(count, interrupted)) {
            return cap + 1;
        }
        ray.c = at->sin_x + ray.kappa * (at->x + pi<I>());
    }
    return cap + 1;
}

namespace detail {

/// An enclosure of the t of first contact with the bridge.
template <class I>
I bridge_contacts(const BridgeApproach<I>& ray, const I& latest, const I& r) {
    // f(t) = height + kappa t - r sin t of the lowest ray is convex: f > 0 and f' < 0 prove that no contact
    // comes before.
    const double t =
        guess_bridge_contact(low_end(ray.height).lo(), low_end(ray.kappa).lo(), high_end(r).hi());
    const I early(std::max(0.0, t * (1 - 1e-9) - 1e-12));
    const SinCos<I> at = sin_cos(early);
    const bool proved =
        certainly_less(early, latest) &&
        certainly_less(high_end(r) * at.sin, low_end(ray.height) + low_end(ray.kappa) * early) &&
        certainly_less(low_end(ray.kappa), low_end(r) * at.cos);
    return hull(proved ? early : I(0), latest);
}

/// Later collisions, after a contact with the bridge at t in T of rays of slope kappa: to the left or to the
/// right.
template <class I>
long plain_count_after_bridge(const I& t, const I& kappa, const I& r, long cap,
                              const Interrupted& interrupted) {
    const SinCos<I> at = sin_cos(t);
    const I& s = at.cos;
    const I square = r * sqr(s);
    const I numerator = I(2) * r * s - kappa * (I(1) - square);
    const I leftward = I(1) + I(2) * s * kappa - square;  // the sign of the motion to the left
    long most = 0;
    if (!certainly_at_most(leftward, I(0))) {
        bool undecided = false;
        const I slope = slope_of(numerator, leftward, undecided);
        most = undecided
                   ? cap + 1
                   : plain_count(PlainRay<I>{r * at.sin + slope * (pi<I>() - t), slope}, r, cap, interrupted);
    }
    if (!certainly_positive(leftward)) {
        bool undecided = false;
        const I slope = slope_of(numerator, -leftward, undecided);
        most = std::max(
            most, undecided ? cap + 1
                            : plain_count(PlainRay<I>{r * at.sin + slope * t, slope}, r, cap, interrupted));
    }
    return most;
}

}  // namespace detail

/// An upper bound of the number of later collisions of the departures from R to the left. Stops at `cap` + 1,
/// also if interrupted.
template <class I>
[[gnu::flatten]] long plain_later_collisions(PlainDeparture<I> from, const I& r, long cap,
                                             const Interrupted& interrupted = never) {
    const RatioRange<I> range{low_end(r), high_end(r)};
    long most = 0;
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), from.kappa)) {
            return std::max(most, count);
        }
        const BridgeApproach<I> over_corner{max(I(0), from.sin_x + from.kappa * from.x), from.kappa};
        if (!certainly_clears_bridge(low_end(over_corner.height), low_end(from.kappa), high_end(r))) {
            const BridgeApproach<I> highest{high_end(over_corner.height), high_end(from.kappa)};
            const I latest = latest_bridge_contact(highest, low_end(from.kappa), range);
            const I t = detail::bridge_contacts(over_corner, latest, r);
            most = std::max(
                most,
                count + 1 + detail::plain_count_after_bridge(t, from.kappa, r, cap - count, interrupted));
            if (most > cap || certainly_below_bridge(highest, latest, range.r_lo)) {
                return most;
            }
        }
        const PlainRay<I> ray{max(I(0), from.sin_x + from.kappa * (from.x + pi<I>())), from.kappa};
        const auto at = detail::plain_contact(ray);
        if (!at) {
            return std::max(most, count);
        }
        const auto out = reflect_at_light_wall(ray.kappa, at->cos_x, r);
        if (certainly_at_most(out.denominator, I(0))) {
            return std::max(most, count + 1);
        }
        bool undecided = false;
        const I slope = detail::reflected_slope(out, ray.kappa, at->cos_x, r, undecided);
        if (undecided || ends_early(count, interrupted)) {
            return cap + 1;
        }
        from = {at->x, at->sin_x, slope};
    }
    return cap + 1;
}

}  // namespace dumbbell::flight
