#pragma once

#include <optional>

#include "starts/first_flight.hpp"
#include "starts/flight.hpp"

/// Where rays from a light wall touch the bridge ahead, before its top or behind it (lemma L60).
namespace dumbbell::starts {

/// All contacts of a box of rays: their distance from the corner before the bridge, in [0, pi], with its sine
/// and cosine.
template <class I>
struct BridgeContacts {
    I x;
    I sine;
    I cosine;
};

/// The least roots x in [0, pi] of sin x = c + kappa x, for all c and kappa of these intervals; nothing
/// unless it is certain that all of them have one and that sin x - kappa x still rises there: L60.
template <class I>
[[nodiscard]] std::optional<BridgeContacts<I>> bridge_contacts(const I& c, const I& kappa) {
    const auto guess = [](const I& height, const I& slope) -> std::optional<I> {
        const auto start = guess_bridge_contact(approximate(height), approximate(slope), 1);
        I z(start.value_or(0));
        for (int bits = 53; start && bits < PrecisionScope::current(); bits *= 2) {
            const SinCos<I> at = sin_cos(z);
            z = midpoint(z - (at.sin - slope * z - height) / (at.cos - slope));
        }
        return start ? std::optional(z) : std::nullopt;
    };
    const auto near = guess(low_end(c), low_end(kappa));
    const auto far = guess(high_end(c), high_end(kappa));
    if (!certainly_positive(c) || !near || !far || !certainly_at_most(I(0), *near) ||
        !certainly_at_most(*near, pi<I>())) {
        return std::nullopt;
    }
    const auto value = [](const I& x, const I& height, const I& slope) {
        return sin_cos(x).sin - slope * x - height;
    };
    const I rate = sin_cos(*near).cos - low_end(kappa);
    const I rate_far = sin_cos(*far).cos - high_end(kappa);
    if (!certainly_positive(rate) || !certainly_positive(rate_far)) {
        return std::nullopt;
    }
    const I least = low_end(max(I(0), *near - value(*near, low_end(c), low_end(kappa)) / rate));  // L60 (a)
    const I residual = magnitude(value(*far, high_end(c), high_end(kappa)) / rate_far);
    for (const int factor : {2, 8, 64}) {
        const I greatest = high_end(*far + residual * I(factor));
        if (certainly_at_most(least, greatest) && certainly_at_most(greatest, pi<I>()) &&
            certainly_positive(value(greatest, high_end(c), high_end(kappa)))) {  // L60 (b)
            const I x = hull(least, greatest);
            const SinCos<I> at = sin_cos(x);
            return BridgeContacts<I>{x, at.sin, at.cos};
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::starts
