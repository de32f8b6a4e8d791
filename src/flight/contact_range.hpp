#pragma once

#include <optional>
#include <utility>

#include "flight/contact.hpp"
#include "number/enclosure.hpp"

namespace dumbbell::flight {

/// The contact's corner distance x over a set of rays, with its sine and cosine.
template <class I>
struct ContactRange {
    I x;
    SinCos<I> at;
};

namespace detail {

/// Where the set's middle ray seems to meet the wall.
inline ContactGuess<Interval> middle_guess(const Interval& c, const Interval& kappa) {
    return guess_contact(midpoint(c), midpoint(kappa));
}
/// The same with little more than half of the working precision, and a little to the left: so g(z) < 0,
/// Newton's step from z is certain to be forward, and what it leaves out is below the working precision.
inline ContactGuess<BigInterval> middle_guess(const BigInterval& c, const BigInterval& kappa) {
    const int half = PrecisionScope::current() / 2;
    const PrecisionScope scope(half + 10);
    auto guess = guess_contact(midpoint(c), midpoint(kappa));
    guess.z = low_end(guess.z - guess.z * two_to(-half - 4));
    return guess;
}

}  // namespace detail

/// For all rays with c in `c` (>= 0) and kappa in `kappa`: they collide, transversally, in this range;
/// nothing if that is not certain.
///
/// Lemma L12 (a), (b) at one point z, each formula with every ray's own c and kappa, and (d). In each the ray
/// of the least c and kappa makes one end and that of the greatest the other, so that the ends are only as
/// far apart as the rays make them, but for terms of second order and rounding: so an orbit can be followed
/// over many thousands of flights, where bounds that lost a constant factor per flight (lowest_contact,
/// highest_contact on sets) would be worthless.
template <class I>
std::optional<ContactRange<I>> contact_range(const I& c, const I& kappa) {
    const auto [z, hits] = detail::middle_guess(c, kappa);
    const SinCos<I> at = sin_cos(z);
    const I slope = at.cos - kappa;
    if (!hits || !certainly_positive(slope)) {
        return std::nullopt;
    }
    const I newton = (c + kappa * z - at.sin) / slope;  // -g(z)/p
    const I residual = magnitude(newton);
    // Satisfies L12 (b) where residual / slope is small, and is hardly more than the residual.
    const I excess = sqr(residual) / slope + detail::least_step<I>();
    const I step = high_end(residual + excess);
    const I half_square = sqr(step) * I(0.5);
    if (!certainly_at_most(half_square, slope * excess) || !certainly_at_most(z + step, half_pi<I>())) {
        return std::nullopt;
    }
    const I d = hull(low_end(newton), step);  // x - z, L12 (a), (b): |d| <= step
    const I error = hull(-half_square, half_square);
    SinCos<I> at_x{at.sin + at.cos * d + error, at.cos - at.sin * d + error};
    if (!certainly_positive(at_x.cos)) {
        return std::nullopt;  // a wall slope that may be 0 says nothing about the reflection
    }
    return ContactRange<I>{max(I(0), z + d), std::move(at_x)};
}

}  // namespace dumbbell::flight
