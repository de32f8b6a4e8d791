#pragma once

#include <optional>

#include "flight/valley.hpp"

/// Orbits that leave a wall of the valley at a right angle, and go outward (lemma L86): bounds of the flight
/// Y_j(p), from below and from above. As a Ray: its height at the valley's corner, its slope, and r.
namespace dumbbell::flight {

/// The height of the wall with the number i in the passage: R, or the bridge.
template <class I>
I valley_wall(long i, const I& rho) {
    return i % 2 != 0 ? I(1) : rho;
}

/// At most Y_j(p) of all bodies with this rho, or a lesser one, and at least this r; nothing if this
/// precision does not follow it, or there is none. Preconditions: j >= 1, 0 <= p < rho.
template <class I>
std::optional<Ray<I>> outward_from_below(long j, const I& p, const I& rho, const I& r) {
    const I height = valley_wall(j, rho);
    const auto from = contact_from_below<I>({p, I(0), r}, height);
    if (!from) {
        return std::nullopt;
    }
    const I kappa = low_end(r / high_end(height * from->cos_x));
    Ray<I> flight{low_end(p + kappa * from->x), kappa, low_end(r)};
    for (long i = j + 1; i < 2 * j; ++i) {
        if (bounce_from_below(flight, valley_wall(i, rho)) != Bounce::returns) {
            return std::nullopt;
        }
    }
    return flight;
}

/// Behind the contacts of all flights below `flight` with a wall of that height, or a higher one; nothing if
/// some may miss it.
template <class I>
std::optional<Contact<I>> contact_from_above(const Ray<I>& flight, const I& height) {
    return highest_contact(high_end(flight.c / height), high_end(flight.kappa / height));
}

/// Takes the upper bound `flight` (thin; c, kappa >= 0) to a wall of that height, and back; false if it is
/// not certain that all flights below it hit the wall and come back.
template <class I>
bool bounce_from_above(Ray<I>& flight, const I& height) {
    const auto contact = contact_from_above(flight, height);
    if (!contact) {
        return false;
    }
    const auto out = reflect_at_light_wall(flight.kappa, low_end(height * contact->cos_x), flight.r);
    flight.kappa = high_end(out.numerator / out.denominator);
    flight.c = high_end(height * contact->sin_x + flight.kappa * contact->x);
    return certainly_positive(out.denominator);
}

/// At least Y_j(p) of all bodies with this rho, or a greater one, and at most this r, which exists for all of
/// them; nothing if that is not certain. Preconditions: j >= 1, 0 <= p < rho.
template <class I>
std::optional<Ray<I>> outward_from_above(long j, const I& p, const I& rho, const I& r) {
    const I height = valley_wall(j, rho);
    const auto from = contact_from_above<I>({p, I(0), r}, height);
    if (!from) {
        return std::nullopt;
    }
    const I kappa = high_end(r / low_end(height * from->cos_x));
    Ray<I> flight{high_end(p + kappa * from->x), kappa, high_end(r)};
    for (long i = j + 1; i < 2 * j; ++i) {
        if (!bounce_from_above(flight, valley_wall(i, rho))) {
            return std::nullopt;
        }
    }
    return flight;
}

}  // namespace dumbbell::flight
