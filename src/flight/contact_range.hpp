#pragma once

#include <optional>

#include "flight/contact.hpp"
#include "number/enclosure.hpp"

namespace dumbbell::flight {

/// Bounds of the contact's corner distance x over a set of rays.
template <class I>
struct ContactRange {
    Contact<I> least;
    Contact<I> greatest;
};

/// For all rays with c in `c` (>= 0) and kappa in `kappa`: they collide, transversally, between these bounds;
/// nothing if that is not certain.
///
/// Both bounds come from one point z (lemma L12 (a), (b)). They are only as far apart as the rays make them,
/// but for terms of second order and rounding: so an orbit can be followed over many thousands of flights,
/// where bounds that lost a constant factor per flight (lowest_contact, highest_contact on sets) would be
/// worthless.
template <class I>
std::optional<ContactRange<I>> contact_range(const I& c, const I& kappa) {
    const ContactGuess<I> guess = guess_contact(midpoint(c), midpoint(kappa));
    const auto lower = detail::tangent_at(guess.z, low_end(c), low_end(kappa));
    const I upper_slope = lower.at.cos - high_end(kappa);
    if (!guess.hits || !certainly_positive(upper_slope) || !certainly_positive(lower.slope)) {
        return std::nullopt;
    }
    const I x_least = low_end(max(I(0), lower.z - lower.value / lower.slope));  // L12 (a)

    const I upper_value = lower.at.sin - high_end(kappa) * lower.z - high_end(c);
    const I residual = magnitude(upper_value) / upper_slope;
    // Satisfies L12 (b) where residual / slope is small, and is hardly more than the residual.
    const I step = high_end(residual + sqr(residual) / upper_slope + detail::least_step<I>());
    if (!certainly_at_most(residual + sqr(step) / (I(2) * upper_slope), step) ||
        !certainly_at_most(lower.z + step, half_pi<I>())) {
        return std::nullopt;
    }
    const I x_greatest = high_end(lower.z + step);  // L12 (b)

    const SinCos<I> at_least = detail::shifted(lower, x_least);
    const SinCos<I> at_greatest = detail::shifted(lower, x_greatest);
    if (!certainly_positive(at_greatest.cos)) {
        return std::nullopt;  // a wall slope that may be 0 says nothing about the reflection
    }
    return ContactRange<I>{{x_least, low_end(at_least.sin), high_end(at_least.cos)},
                           {x_greatest, high_end(at_greatest.sin), low_end(at_greatest.cos)}};
}

}  // namespace dumbbell::flight
