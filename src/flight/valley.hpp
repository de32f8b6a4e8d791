#pragma once

#include "flight/contact.hpp"
#include "flight/count.hpp"
#include "flight/ray.hpp"
#include "flight/reflection.hpp"

/// The valley between R and the right half of the bridge (lemmas L79, L82): lower bounds of a flight from
/// wall to wall, and with them an upper bound of how often it hits the bridge.
namespace dumbbell::flight {

/// What a lower bound of flights does at the wall ahead.
enum class Bounce { returns, leaves, misses, undecided };

/// Before the contacts of all flights above `flight` with a wall of that height, or a lower one; nothing if
/// they miss it.
template <class I>
std::optional<Contact<I>> contact_from_below(const Ray<I>& flight, const I& height) {
    const I kappa = low_end(flight.kappa / height);
    return certainly_at_most(I(1), kappa) ? std::nullopt : lowest_contact(low_end(flight.c / height), kappa);
}

/// A flight to the left, at the vertical of the corner of the light wall that it goes to.
template <class I>
Ray<I> over_bridge(const Ray<I>& flight) {
    return {flight.c + flight.kappa * pi<I>(), flight.kappa, flight.r};
}

/// Takes the lower bound `flight` (thin; c >= 0, the slope of any sign) to the wall of height `height`, 1 for
/// R and rho for the bridge, and back. leaves, misses: no flight above it comes back, or hits the wall.
template <class I>
Bounce bounce_from_below(Ray<I>& flight, const I& height) {
    const auto contact = contact_from_below(flight, height);
    if (!contact) {
        return Bounce::misses;
    }
    const auto out = reflect_at_light_wall(flight.kappa, high_end(height * contact->cos_x), flight.r);
    if (certainly_at_most(high_end(out.denominator), I(0))) {
        return Bounce::leaves;
    }
    if (!certainly_positive(out.denominator) && !certainly_positive(out.numerator)) {
        return Bounce::undecided;
    }
    // By the upper end of the denominator where the numerator is positive: the quotient's lower end, too.
    flight.kappa = certainly_positive(out.denominator)
                       ? low_end(out.numerator / out.denominator)
                       : low_end(low_end(out.numerator) / high_end(out.denominator));
    flight.c = max(I(0), low_end(height * contact->sin_x + flight.kappa * contact->x));
    return Bounce::returns;
}

/// The straight wedge's ray along the bridge (L82), from below, behind 2 hits + 1 bounces; or what becomes of
/// it before. rho and r enclose those of the body.
template <class I>
Bounce along_bridge(Ray<I>& ray, long hits, const I& rho, const I& r, const Interrupted& interrupted) {
    ray = {I(0), low_end(-rho), low_end(r)};
    Bounce last = Bounce::returns;
    for (long bounces = 0; bounces <= 2 * hits && last == Bounce::returns; ++bounces) {
        last = ends_early(bounces, interrupted) ? Bounce::undecided
                                                : bounce_from_below(ray, bounces % 2 == 0 ? I(1) : rho);
    }
    return last;
}

/// Certain that J is at most `hits`.
template <class I>
bool corner_hits_at_most(long hits, const I& rho, const I& r, const Interrupted& interrupted) {
    Ray<I> ray;
    const Bounce last = along_bridge(ray, hits, rho, r, interrupted);
    return last == Bounce::returns ? certainly_at_most(rho, ray.kappa) : last != Bounce::undecided;
}

/// An upper bound of T if J is `hits`; `cap` + 1 if none up to `cap` is certain.
template <class I>
long even_at_most(long hits, const I& rho, const I& r, long cap, const Interrupted& interrupted) {
    Ray<I> ray;
    const Bounce last = along_bridge(ray, hits, rho, r, interrupted);
    if (last != Bounce::returns) {
        return last == Bounce::undecided ? cap + 1 : 0;
    }
    return as_long(count_at_most(over_bridge(ray), cap, interrupted));
}

}  // namespace dumbbell::flight
