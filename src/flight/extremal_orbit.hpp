#pragma once

#include <optional>
#include <utility>

#include "flight/contact_range.hpp"
#include "flight/eigen_interval.hpp"
#include "flight/ray.hpp"
#include "flight/reflection.hpp"

/// The two extremal orbits of proofs/theorem.md and how they move with the mass ratio: what the critical
/// ratios are computed from.
namespace dumbbell::flight {

/// The horizontal ray that touches the bridge's top, and the ray out of a corner along the bridge's tangent.
enum class ExtremalOrbit { top, corner };

/// A flight of an orbit, counted from 1.
struct ExtremalFlight {
    ExtremalOrbit orbit;
    long flight;
};

/// The flight that is tangent to the hump at the critical ratio q_c(n), n >= 3 (Theorem 2 (c)).
[[nodiscard]] constexpr ExtremalFlight tangent_flight(long n) {
    return n % 2 != 0 ? ExtremalFlight{ExtremalOrbit::top, (n - 1) / 2}
                      : ExtremalFlight{ExtremalOrbit::corner, (n - 2) / 2};
}

template <class I>
[[nodiscard]] Ray<I> extremal_ray(ExtremalOrbit orbit, const I& r) {
    return orbit == ExtremalOrbit::top ? Ray<I>{r, I(0), r} : Ray<I>{pi<I>() * r, r, r};
}

/// A flight of an orbit at every r of the range `ray.r`: enclosures of its c and kappa, and of their
/// derivatives by r there.
template <class I>
struct MovingRay {
    Ray<I> ray;
    Eigen::Matrix<I, 2, 1> rate;  ///< d(c, kappa)/dr
};

template <class I>
[[nodiscard]] MovingRay<I> first_moving_ray(ExtremalOrbit orbit, const I& r) {
    const bool top = orbit == ExtremalOrbit::top;
    return {extremal_ray(orbit, r), {top ? I(1) : pi<I>(), I(top ? 0 : 1)}};
}

namespace detail {

/// What is between two flights, at every r of a range.
template <class I>
struct Collision {
    Ray<I> next;
    ContactRange<I> contact;
    I share;  ///< D / w
};

template <class I>
std::optional<Collision<I>> collision(const Ray<I>& before) {
    const auto& [c, kappa, r] = before;
    auto contact = contact_range(c, kappa);
    if (!contact) {
        return std::nullopt;
    }
    const auto& [x, at] = *contact;
    // kappa' by the first formula in the proof of L5 (f).
    I share = at.cos - r / at.cos - (kappa + kappa);
    if (!certainly_positive(share)) {
        return std::nullopt;
    }
    const I rise = (r + sqr(kappa)) / share;
    const I next_kappa = kappa + (rise + rise);
    if (!certainly_less(next_kappa, I(1))) {
        return std::nullopt;
    }
    Ray<I> next{at.sin + next_kappa * (x + pi<I>()), next_kappa, r};
    return Collision<I>{std::move(next), std::move(*contact), std::move(share)};
}

/// The derivatives by r behind a collision, from those before it: of x, from sin x = c + kappa x; of kappa',
/// with the derivatives of (2) in L5 (b); of c' = sin x + kappa' (x + pi). All summands and factors are >= 0,
/// so that enclosures of them do not widen by cancellation.
template <class I>
Eigen::Matrix<I, 2, 1> rate_after(const MovingRay<I>& before, const Collision<I>& collision) {
    const auto& [c, kappa, r] = before.ray;
    const auto& [next, contact, share] = collision;
    const auto& [x, at] = contact;
    const I& kappa_rate = before.rate[1];
    const I slope = at.cos - kappa;
    const I a = sqr(at.cos) + r;
    const I x_rate = (before.rate[0] + x * kappa_rate) / slope;
    const I steepening = I(2) * (sqr(kappa) + r) * at.sin * x_rate;
    const I next_kappa_rate =
        (a * (steepening + a * kappa_rate) + I(2) * at.cos * sqr(slope)) / sqr(at.cos * share);
    return {(at.cos + next.kappa) * x_rate + (x + pi<I>()) * next_kappa_rate, next_kappa_rate};
}

}  // namespace detail

/// The flight after the next collision; nothing unless it is certain that at every r of the range the flight
/// collides, transversally, and comes back (D > 0, kappa' < 1).
///
/// Plain enclosures of formulas in which x, w = cos x, kappa and r stand so that one end is that of the least
/// and the other that of the greatest r of the range: by L5 the state moves monotonely with the state before
/// and with r. So the ends are only as far apart as the orbits at both ends of the range, but for rounding.
template <class I>
[[nodiscard]] std::optional<Ray<I>> after_collision(const Ray<I>& before) {
    auto collision = detail::collision(before);
    return collision ? std::optional(std::move(collision->next)) : std::nullopt;
}

/// The same with the derivatives by r.
template <class I>
[[nodiscard]] std::optional<MovingRay<I>> after_collision(const MovingRay<I>& before) {
    auto collision = detail::collision(before.ray);
    if (!collision) {
        return std::nullopt;
    }
    auto rate = detail::rate_after(before, *collision);
    return MovingRay<I>{std::move(collision->next), std::move(rate)};
}

/// The margin m = M(kappa) - c of a flight, M(kappa) = sqrt(1 - kappa^2) - kappa acos kappa. It collides iff
/// m > 0 and is tangent to the hump iff m = 0 (L4 (a); theorem.md, notation). Precondition: 0 <= kappa,
/// certainly.
template <class I>
[[nodiscard]] I margin(const Ray<I>& flight) {
    // M falls with kappa.
    const auto height = [](const I& kappa) {
        return sqrt(I(1) - sqr(kappa)) - kappa * (half_pi<I>() - asin(kappa));
    };
    const auto& [c, kappa, r] = flight;
    return hull(low_end(height(high_end(kappa)) - high_end(c)),
                high_end(height(low_end(kappa)) - low_end(c)));
}

/// The margin's derivative by r. Precondition: 0 <= kappa, certainly.
template <class I>
[[nodiscard]] I margin_rate(const MovingRay<I>& flight) {
    return -((half_pi<I>() - asin(flight.ray.kappa)) * flight.rate[1] + flight.rate[0]);
}

}  // namespace dumbbell::flight
