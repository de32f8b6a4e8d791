#pragma once

#include "base/interrupted.hpp"
#include "flight/contact.hpp"
#include "flight/ray.hpp"
#include "flight/reflection.hpp"

/// Certified bounds of G, the number of later collisions of a set of rays with the light walls (lemmas L4,
/// L5).
namespace dumbbell {

/// An upper bound of G over all rays that lie at or above `lowest` in c, kappa and r: the lowest, flattest
/// ray is followed with lower bounds, and a contact counts unless a strict miss is certain. Stops at `cap` +
/// 1 ("more than cap"), also if interrupted. Precondition: lowest.c >= 0, lowest.kappa >= -lowest.r.
template <class I>
long count_at_most(const Ray<I>& lowest, long cap, const Interrupted& interrupted = never) {
    const I r = low_end(lowest.r);
    I c = low_end(lowest.c);
    I kappa = low_end(lowest.kappa);
    for (long count = 0; count <= cap; ++count) {
        if (certainly_at_most(I(1), kappa)) {
            return count;  // L3
        }
        const auto contact = lowest_contact(c, kappa);
        if (!contact) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, contact->cos_x, r);
        const I denominator = high_end(out.denominator);
        if (certainly_at_most(denominator, I(0))) {
            return count + 1;  // L1: leaves the cell
        }
        if (!certainly_positive(out.numerator)) {
            return cap + 1;  // bounds too coarse to go on (or NaN): undecided
        }
        if (ends_early(count, interrupted)) {
            return cap + 1;
        }
        kappa = low_end(low_end(out.numerator) / denominator);
        c = low_end(contact->sin_x + kappa * (contact->x + pi<I>()));
    }
    return cap + 1;
}

/// A lower bound of G over all rays that lie at or below `highest` in c (c >= 0), kappa and r: the highest,
/// steepest ray is followed with upper bounds, and only certain, transversal collisions count. Stops at
/// `cap`, and early if interrupted.
template <class I>
long count_at_least(const Ray<I>& highest, long cap, const Interrupted& interrupted = never) {
    const I r = high_end(highest.r);
    I c = high_end(highest.c);
    I kappa = high_end(highest.kappa);
    for (long count = 0; count < cap; ++count) {
        if (!certainly_less(kappa, I(1))) {
            return count;
        }
        const auto contact = highest_contact(c, kappa);
        if (!contact) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, contact->cos_x, r);
        if (!certainly_positive(out.denominator) || ends_early(count, interrupted)) {
            return count + 1;
        }
        kappa = high_end(out.numerator / out.denominator);
        c = high_end(contact->sin_x + kappa * (contact->x + pi<I>()));
    }
    return cap;
}

}  // namespace dumbbell
