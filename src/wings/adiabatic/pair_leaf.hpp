#pragma once

#include <optional>

#include "adiabatic/flight_leaf.hpp"

/// The leaves of a run and of a scattering (format-adiabatic.md, section 4): pairs of a first and a
/// later collision, u and v their angles from the vertical (L36, L37).
namespace dumbbell::adiabatic {

/// Just before the first collision |phidot| = 1 and ydot = -delta s.
template <class I>
struct Pair {
    LightContact<I> first;
    LightContact<I> later;
    I u, s, v;
    Masses<I> masses;

    I kappa_over_delta;  ///< of the slope before the first collision
    I kappa;
    I root_energy;  ///< sqrt(E)
    I share;        ///< S_0

    Pair(const I& angle, const I& fall, const I& last, const Masses<I>& m)
        : first(light_contact(half_pi<I>() - angle, m.beta2)),
          later(light_contact(half_pi<I>() - last, m.beta2)),
          u(angle),
          s(fall),
          v(last),
          masses(m),
          kappa_over_delta(-fall / m.beta2),
          kappa(m.delta * kappa_over_delta),
          root_energy(sqrt(I(1) + sqr(fall) / m.beta2)),
          share(mean_share(first, kappa, m.r)) {}

    /// S_0 g_0/delta, without S.
    [[nodiscard]] I first_half_step() const {
        return first.f * (masses.delta_over_beta2 / first.w - s / masses.beta2) /
               (first.w + masses.r / first.w);
    }
};

/// What is known at the later collision from a class: (S_n - S_0)/delta, S_n, and the greatest and least
/// slope.
template <class I>
struct LaterCollision {
    bool none = false;  ///< certainly there is no such collision
    I change;
    I share;
    I greatest_sigma;
    I least_sigma;
};

/// L35 and L36 for the pair; nothing where the class does not apply.
template <class I>
[[nodiscard]] std::optional<LaterCollision<I>> later_collision(const Pair<I>& pair, const I& least_share,
                                                               const Potential<I>& potential) {
    const auto& m = pair.masses;
    const I scale = pair.root_energy * m.delta_over_beta2;
    const I loss = scale * potential.greatest_value(pair.v);
    const I gain = scale * potential.greatest_value(pair.u);
    if (!certainly_at_most(least_share * pair.root_energy, pair.share - m.delta * loss)) {
        return std::nullopt;
    }
    LaterCollision<I> result;
    result.change = hull(-loss, gain);
    result.share = pair.share + m.delta * result.change;
    const I& w = pair.later.w;
    const I a = m.root_r / w;
    const I a2 = m.r / sqr(w);
    const I tau = low_end(result.share * (I(1) + a2) / (pair.later.f * pair.root_energy));
    const I below = sqr(tau) - a2;
    if (!certainly_positive(tau) || !certainly_positive(below)) {
        return std::nullopt;
    }
    const I square = I(1) + a2 - sqr(tau);
    if (certainly_less(square, I(0))) {
        result.none = true;
        return result;
    }
    const I root = tau * sqrt(max(I(0), square));
    result.greatest_sigma = (root - a) / below;
    result.least_sigma = (-root - a) / below;
    return result;
}

/// Upper bound of |I_n - I_0|/delta by a class, I with |phidot| before the collisions; nothing if there is
/// none.
template <class I>
[[nodiscard]] std::optional<I> run_error(const Pair<I>& pair, const I& least_share,
                                         const Potential<I>& potential) {
    const auto at = later_collision(pair, least_share, potential);
    if (!at || at->none) {
        return at ? std::optional(I(0)) : std::nullopt;
    }
    const auto& m = pair.masses;
    const I& w = pair.later.w;
    const I root_beta2 = sqrt(m.beta2);
    const auto step = [&](const I& sigma) {
        return half_step(w, sigma * m.root_r, sigma / root_beta2, m.delta_over_beta2);
    };
    if (!certainly_positive(w - at->greatest_sigma * m.root_r)) {
        return std::nullopt;
    }
    const I total = at->change + at->share * hull(step(at->least_sigma), step(at->greatest_sigma)) -
                    pair.first_half_step();
    return magnitude(total);
}

/// Whether no descending flight of a scattering touches the bridge (L37).
template <class I>
[[nodiscard]] bool certainly_above_bridge(const Pair<I>& pair) {
    const I& r = pair.masses.r;
    const I at_bridge = (half_pi<I>() + asin(pair.masses.beta2 * r)) * sqrt(I(1) + r / (I(1) - sqr(r)));
    return certainly_less(at_bridge * pair.root_energy, pair.share);
}

/// The same of |I_N - I_0|/sqrt(delta), I_N with |phidot| after the last collision, of a whole scattering
/// (L37).
template <class I>
[[nodiscard]] std::optional<I> scattering_error(const Pair<I>& pair, const I& least_share,
                                                const Potential<I>& potential) {
    if (!certainly_above_bridge(pair)) {
        return std::nullopt;  // a collision of the heavy mass may come between: nothing is known of the later
                              // one
    }
    const auto at = later_collision(pair, least_share, potential);
    if (!at || at->none) {
        return at ? std::optional(I(0)) : std::nullopt;
    }
    const auto& m = pair.masses;
    const I& w = pair.later.w;
    const I a2 = m.r / sqr(w);
    const I steepest = at->greatest_sigma * m.root_r;
    if (!certainly_less(a2, I(1)) || !certainly_positive(w - steepest)) {
        return std::nullopt;
    }
    // kappa = -2 r w/(w^2 - r), below which the flight after the collision descends.
    const I flattest_over_delta = I(-2) * m.delta_over_beta2 / (w * (I(1) - a2));
    const I step = hull(half_step(w, m.delta * flattest_over_delta, flattest_over_delta, m.delta_over_beta2),
                        half_step(w, steepest, at->greatest_sigma / sqrt(m.beta2), m.delta_over_beta2));
    const I total = at->change - at->share * step - pair.first_half_step();
    I error = magnitude(total);
    if (!certainly_positive(sqr(w) - I(2) * steepest * w - m.r)) {
        // The light mass may go on in its old direction.
        error = max(error, magnitude((-at->share * (I(1) - m.delta * step) - pair.first.f) / m.delta));
    }
    return high_end(error * sqrt(m.delta));
}

/// Whether the reversed incoming ray of the first collision certainly meets the light wall: then it is not
/// the first.
template <class I>
[[nodiscard]] bool certainly_not_first(const Pair<I>& pair) {
    const I k = high_end(-pair.kappa);
    const I c = high_end(pair.first.s + k * (pair.first.x + pi<I>()));
    return flight::highest_contact(c, k).has_value();
}

}  // namespace dumbbell::adiabatic
