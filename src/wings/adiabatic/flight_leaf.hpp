#pragma once

#include <limits>
#include <optional>

#include "adiabatic/drift.hpp"
#include "number/enclosure.hpp"

/// The leaves of a class (format-adiabatic.md, section 3): boxes of flights on which (D) of L35 holds.
namespace dumbbell::adiabatic {

/// What is certain of a box, and how far it is from being certain: 0 or less if it is, infinite if nothing is
/// known.
struct Verdict {
    bool outside = false;
    double excess = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool closed() const { return outside || excess <= 0; }
};

/// The part of the angles u from the vertical that is at least `margin` and at most pi/2; nothing if there
/// certainly is none.
template <class I>
[[nodiscard]] std::optional<I> admitted_angle(const I& u, const I& margin) {
    if (certainly_less(half_pi<I>(), u) || certainly_less(u, low_end(margin))) {
        return std::nullopt;
    }
    return hull(max(low_end(u), low_end(margin)), min(high_end(u), high_end(half_pi<I>())));
}

/// Flights whose upper contact is at angle u from the vertical. `margin`: the least u of the hypotheses.
/// Precondition: 0 <= u, 0 <= sigma.
template <class I>
[[nodiscard]] Verdict judge_flights(const I& u, const I& sigma, const Masses<I>& masses, const I& margin,
                                    const I& least_share, const Potential<I>& potential) {
    constexpr Verdict outside{true, 0};
    const auto angle = admitted_angle(u, margin);
    if (!angle) {
        return outside;
    }
    const LightFlights<I> flights(half_pi<I>() - *angle, sigma, masses);
    const I upper_sine = cos(*angle);
    if (certainly_less(upper_sine, flights.k * (pi<I>() + flights.x)) ||
        certainly_less(sin(*angle), flights.k)) {
        return outside;
    }
    const I lower = hull(flights.least_root(I(-1)), flights.greatest_root(I(-1)));
    const I share = mean_share(light_contact(lower, masses.beta2), -flights.k, masses.r);
    if (certainly_less(share, least_share * sqrt(I(1) + sqr(sigma)))) {
        return outside;
    }
    const auto sums = drift_sums(flights, [&](const I& at) { return potential.least_density(at); });
    if (!sums) {
        return {};
    }
    const I over = max(sums->drift - sums->growth, -sums->drift) / magnitude(sums->growth);
    return {false, over.hi() <= 0 || over.hi() > 0 ? over.hi() : std::numeric_limits<double>::infinity()};
}

}  // namespace dumbbell::adiabatic
