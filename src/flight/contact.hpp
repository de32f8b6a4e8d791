#pragma once

#include <optional>

#include "flight/contact_guess.hpp"
#include "flight/way_to_contact.hpp"
#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// The flight to a light wall: bounds of the least root x of sin x = c + kappa x in [0, pi/2] (lemmas L4,
/// L12).
namespace dumbbell::flight {

/// A bound of the contact's corner distance x, with the sine and cosine that belong to it: for a lower bound
/// sin_x is a lower and cos_x an upper bound, for an upper bound the other way round. All thin, but where it
/// is said to enclose contacts.
template <class I>
struct Contact {
    I x;
    I sin_x;
    I cos_x;
};

namespace detail {

/// g(x) = sin x - kappa x - c and its derivative at a point z, enclosed; one sine-cosine pair serves
/// everything.
template <class I>
struct Tangent {
    I z;
    SinCos<I> at;
    I value;
    I slope;
};

template <class I>
Tangent<I> tangent_at(const I& z, const SinCos<I>& at, const I& c, const I& kappa) {
    return {z, at, at.sin - kappa * z - c, at.cos - kappa};
}
template <class I>
Tangent<I> tangent_at(const I& z, const I& c, const I& kappa) {
    return tangent_at(z, sin_cos(z), c, kappa);
}

/// Sine and cosine near z, lemma L12 (d).
template <class I>
SinCos<I> shifted(const Tangent<I>& t, const I& x) {
    const I d = x - t.z;
    const I half_square = sqr(d) * I(0.5);
    const I error = hull(-half_square, half_square);
    return {t.at.sin + t.at.cos * d + error, t.at.cos - t.at.sin * d + error};
}

/// A step d > 0 for lemma L12 (b) also where the residual is 0: exact, and far below the working precision.
template <class I>
I least_step();
template <>
inline Interval least_step() {
    return Interval(0x1p-1000);
}
template <>
inline BigInterval least_step() {
    return two_to(-1000 - PrecisionScope::current());
}

/// Lemma L12 (c): g < 0 on all of [0, pi/2].
template <class I>
bool strict_miss(const Tangent<I>& t, const I& c, const I& kappa) {
    const I at_zero = c - t.at.sin + t.z * t.at.cos;
    const I at_peak = c + kappa * half_pi<I>() - t.at.sin - (half_pi<I>() - t.z) * t.at.cos;
    return certainly_positive(at_zero) && certainly_positive(at_peak);
}

}  // namespace detail

/// Where the next contact of a bound that is followed seems to be: a guess.
template <class I>
class ContactTrend {
  public:
    /// After a contact, which a flight of slope kappa leaves.
    void add(const Contact<I>& from, const I& kappa) {
        const double x = approximate(from.x);
        next_ = known_ < 3 ? step_from(x, from, approximate(kappa)) : 4 * (x + x_[1]) - 6 * x_[0] - x_[2];
        x_[2] = x_[1];
        x_[1] = x_[0];
        x_[0] = x;
        ++known_;
    }
    /// The flight comes from elsewhere.
    void forget() { *this = {}; }

    /// no_start if there is nothing to tell it from.
    [[nodiscard]] double next() const { return next_; }

  private:
    /// From the same distance on the other wall, which is kappa (2 x + pi) below the ray.
    static double step_from(double x, const Contact<I>& from, double kappa) {
        const SinCosGuess at{approximate(from.sin_x), approximate(from.cos_x)};
        const double inverse = 1 / (at.cos - kappa);
        return x + way_to_contact(kappa * (x + x + approximate(pi<I>())) * inverse, inverse, at);
    }

    double x_[3] = {};  ///< the last contacts, the last one first
    int known_ = 0;
    double next_ = no_start;
};

/// For all rays whose c and kappa are at least these (thin) ones: a lower bound of x for every ray that
/// collides, or nothing if certainly none does. The bounds themselves may lie outside the domain of rays (L5
/// (e)); the rays have c >= 0.
template <class I>
std::optional<Contact<I>> lowest_contact(const I& c, const I& kappa, double start = no_start) {
    const ContactPlace<I> place = contact_place(c, kappa, start);
    auto tangent = detail::tangent_at(place.z, place.at, c, kappa);
    if (!place.hits) {
        if (detail::strict_miss(tangent, c, kappa)) {
            return std::nullopt;
        }
        // Too close to a tangency: bound x from a point a little to the left, where g certainly increases.
        tangent = detail::tangent_at(low_end(place.z * I(1 - 0x1p-20)), c, kappa);
    }
    I x(0);
    if (certainly_positive(tangent.slope)) {
        x = low_end(max(I(0), tangent.z - tangent.value / tangent.slope));  // L12 (a)
    }
    const SinCos<I> at = detail::shifted(tangent, x);
    return Contact<I>{x, low_end(at.sin), high_end(at.cos)};
}

/// For all rays whose c and kappa are at most these (thin) ones, with c >= 0: an upper bound of x, or nothing
/// if it is not certain that all of them collide, transversally.
template <class I>
std::optional<Contact<I>> highest_contact(const I& c, const I& kappa, double start = no_start) {
    const ContactPlace<I> place = contact_place(c, kappa, start);
    const auto tangent = detail::tangent_at(place.z, place.at, c, kappa);
    if (!certainly_positive(tangent.slope)) {
        return std::nullopt;
    }
    const I residual = max(tangent.value, -tangent.value) / tangent.slope;
    const I step = high_end(residual * I(2) + detail::least_step<I>());
    const bool proved = certainly_at_most(residual + sqr(step) / (I(2) * tangent.slope), step) &&
                        certainly_at_most(tangent.z + step, half_pi<I>());  // L12 (b)
    if (!proved && !certainly_positive(tangent.value)) {
        return std::nullopt;
    }
    const I x = proved ? high_end(tangent.z + step) : tangent.z;
    const SinCos<I> at = detail::shifted(tangent, x);
    const I cos_x = low_end(at.cos);
    if (!certainly_positive(cos_x)) {
        return std::nullopt;  // a wall slope that may be 0 says nothing about the reflection
    }
    return Contact<I>{x, high_end(at.sin), cos_x};
}

}  // namespace dumbbell::flight
