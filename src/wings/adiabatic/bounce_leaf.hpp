#pragma once

#include <optional>

#include "adiabatic/flight_leaf.hpp"
#include "flight/reflection.hpp"

/// The leaves of Lemma 3.1 and Corollary 3.2 (format-adiabatic.md, section 5): one collision and the
/// next (L38).
namespace dumbbell::adiabatic {

/// A collision at angle u from the vertical; just before it |phidot| = 1 and ydot = -delta s.
template <class I>
struct Bounce {
    LightContact<I> at;
    I s;
    Masses<I> masses;
    I kappa;

    Bounce(const I& u, const I& fall, const Masses<I>& m)
        : at(light_contact(half_pi<I>() - u, m.beta2)),
          s(fall),
          masses(m),
          kappa(-(m.delta * fall) / m.beta2) {}

    [[nodiscard]] I rho() const { return sqrt(sqr(at.w) + I(2) * masses.r + sqr(masses.r)); }
    /// Positive iff the light mass turns back (L33).
    [[nodiscard]] I forward() const { return sqr(at.w) - I(2) * kappa * at.w - masses.r; }
    /// E1 of L38 (a).
    [[nodiscard]] I speed_error() const {
        const I& r = masses.r;
        const I square = sqr(at.w) + r;
        return I(2) * (r + abs(kappa) * sqr(r * at.s) / (rho() * (square + at.w * rho()))) / square;
    }
};

/// The flight after the collision.
template <class I>
struct NextContact {
    bool none = false;  ///< certainly no collision
    I x;                ///< its corner distance, where there is one
    I slope;
};

/// The next contact with the light wall, or nothing if it is not certain that all light masses turn back.
template <class I>
[[nodiscard]] std::optional<NextContact<I>> next_contact(const Bounce<I>& bounce) {
    const LightContact<I>& at = bounce.at;
    const I& r = bounce.masses.r;
    const auto low = flight::reflect_at_light_wall(low_end(bounce.kappa), high_end(at.w), low_end(r));
    if (!certainly_positive(low.denominator)) {
        return std::nullopt;
    }
    const I least = low_end(low.numerator / low.denominator);
    const auto height = [&](const I& slope, const I& x) { return sin(x) + slope * (x + pi<I>()); };
    const I lowest = low_end(height(least, low_end(at.x)));
    const auto first = flight::lowest_contact(max(I(0), lowest), least);
    if (!first || certainly_at_most(I(1), least)) {
        return NextContact<I>{true, at.x, least};
    }
    const auto high = flight::reflect_at_light_wall(high_end(bounce.kappa), low_end(at.w), high_end(r));
    if (!certainly_positive(high.denominator) || !certainly_positive(bounce.forward())) {
        return std::nullopt;
    }
    const I greatest = high_end(high.numerator / high.denominator);
    const I highest = high_end(height(greatest, high_end(at.x)));
    if (certainly_less(highest, I(0))) {
        return NextContact<I>{true, at.x, least};
    }
    const auto last = flight::highest_contact(highest, greatest);
    return NextContact<I>{false, hull(first->x, last ? last->x : high_end(half_pi<I>())),
                          hull(least, greatest)};
}

/// E2 of L38 (b), enclosed.
template <class I>
[[nodiscard]] I height_error(const Bounce<I>& bounce, const NextContact<I>& next) {
    const auto& m = bounce.masses;
    const LightContact<I>& at = bounce.at;
    const I path = pi<I>() + at.x + next.x;
    const I slope_of_wall = cos(hull(at.x, next.x));
    I step = next.x - at.x;
    if (certainly_positive(slope_of_wall)) {
        step = intersection(step, next.slope * path / slope_of_wall);
    }
    const I z = m.beta2 * at.s * (I(2) * m.r + sqr(m.r)) / (bounce.rho() + at.w);
    const I turn = I(2) * m.beta2 * at.w * (m.r + sqr(bounce.kappa)) * path / bounce.forward();
    return abs(turn - m.delta * bounce.s * (step + I(2) * asin(z)));
}

}  // namespace dumbbell::adiabatic
