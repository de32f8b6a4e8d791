#pragma once

#include <optional>

#include "model/flight.hpp"
#include "model/later_count.hpp"
#include "model/reflection.hpp"

/// The first collision of a falling dumbbell over a box of states, in closed forms that lose little of the
/// correlations and that a verifier can repeat (format-initial.md, section 5).
namespace dumbbell {

/// The angle phi at which `mass` touches, for all states of the box, all of whose contacts lie in `times`.
///
/// The mean value form of phi' = phi + phidot T. With N = N.v the rate of the clearance at the contact (N < 0
/// on `times`), implicit differentiation of clearance(T) = 0 gives d phi'/d phi = yhatdot / N, d phi'/d
/// phidot = T yhatdot / N, d phi'/d yhat = -phidot / N, d phi'/d yhatdot = -phidot T / N and d phi'/d r = 0
/// (light), phidot sin phi' / N (heavy).
template <class I>
[[nodiscard]] I contact_angle(const State<I>& s, Mass mass, const I& times) {
    const I natural = s.phi + s.phidot * times;
    const State<I> m{midpoint(s.phi),     midpoint(s.yhat), midpoint(s.phidot),
                     midpoint(s.yhatdot), midpoint(s.r),    I(0)};
    const I t = midpoint(times);
    const I centre = intersection(times, t - clearance(m, mass, t) / clearance_rate(m, mass, times));
    const I rate = clearance_rate(s, mass, times);
    I change = s.yhatdot * ((s.phi - m.phi) + times * (s.phidot - m.phidot)) -
               s.phidot * ((s.yhat - m.yhat) + times * (s.yhatdot - m.yhatdot));
    if (mass == Mass::heavy) {
        change = change + s.phidot * sin_cos(natural).sin * (s.r - m.r);
    }
    return intersection(natural, m.phi + m.phidot * centre + change / rate);
}

/// The slope d yhat / d phi after the reflection of states that fall (yhatdot < 0) at the contact angle phi.
/// With m = phidot / -yhatdot and c = cos phi, (1) of L0 gives the slope as a quotient
///   light: (r - c^2 - 2 r c m) / (m (r - c^2) + 2 c),           heavy: (1 - r c^2 + 2 r c m) / (m (1 - r
///   c^2) - 2 c),
/// the denominator having the sign of phidot'. Where it keeps its sign the quotient decreases with m, and
/// decreases (light) or increases (heavy) with c: the numerators of its derivatives are
///   light: -(c^2 + r)^2 and -2 (c^2 + r)(1 + r m^2),            heavy: -(1 + r c^2)^2 and 2 (1 + r c^2)(1 +
///   r m^2).
struct FallingReflection {
    bool light;

    template <class I>
    [[nodiscard]] I denominator(const I& m, const I& c, const I& r) const {
        return light ? m * (r - sqr(c)) + I(2) * c : m * (I(1) - r * sqr(c)) - I(2) * c;
    }
    template <class I>
    [[nodiscard]] I slope(const I& m, const I& c, const I& r) const {
        const I turn = I(2) * r * c * m;
        return (light ? r - sqr(c) - turn : I(1) - r * sqr(c) + turn) / denominator(m, c, r);
    }
    /// Over all m, c of these intervals, from two opposite ends. Precondition: the denominator keeps its
    /// sign.
    template <class I>
    [[nodiscard]] I slopes(const I& m, const I& c, const I& r) const {
        const I least_c = light ? high_end(c) : low_end(c);
        const I greatest_c = light ? low_end(c) : high_end(c);
        return hull(slope(high_end(m), least_c, r), slope(low_end(m), greatest_c, r));
    }
};

/// What a ray does that meets the bridge before its top, over a box of rays: `ray` is a way out of a light
/// wall, all of whose states touch the bridge at a distance x in [0, pi/2] behind the corner. Nothing if
/// that, or the direction after it, is not certain.
///
/// x is the least root of sin x = c + k x with c = height / r, k = slope / r: it increases with c and k (L5).
/// With c = cos x the reflected slope along the ray's direction is (2 r c - slope (1 - r c^2)) / (1 - r c^2 +
/// 2 slope c), the denominator having the sign of the new direction; where it keeps its sign the quotient
/// decreases with the slope and increases with c: the numerators of its derivatives are -(1 + r c^2)^2 and 2
/// (r + slope^2)(1 + r c^2).
template <class I>
[[nodiscard]] std::optional<Outbound<I>> off_the_bridge(const Outbound<I>& ray, const I& r) {
    const I height = ray.height / r;
    const I slope = ray.slope / r;
    if (!certainly_positive(ray.height) || !certainly_less(slope, I(1))) {
        return std::nullopt;
    }
    const auto least = lowest_contact(low_end(height), low_end(slope));
    const auto greatest = highest_contact(high_end(height), high_end(slope));
    if (!least || !greatest) {
        return std::nullopt;
    }
    const I x = hull(least->x, greatest->x);
    const auto forward = [&](const I& k, const I& c) { return I(1) - r * sqr(c) + I(2) * k * c; };
    const auto reflected = [&](const I& k, const I& c) {
        return (I(2) * r * c - k * (I(1) - r * sqr(c))) / forward(k, c);
    };
    const I onward = forward(ray.slope, hull(greatest->cos_x, least->cos_x));
    const bool back = certainly_positive(-onward);
    if (!back && !certainly_positive(onward)) {
        return std::nullopt;
    }
    const I along =
        hull(reflected(high_end(ray.slope), greatest->cos_x), reflected(low_end(ray.slope), least->cos_x));
    const I run = back ? x : pi<I>() - x;
    const I rise = back ? -along : along;
    const I top = r * hull(least->sin_x, greatest->sin_x);
    return Outbound<I>{back ? -ray.direction : ray.direction, ray.corner + (back ? 0 : ray.direction), run,
                       top + rise * run, rise};
}

/// What a ray does at the light wall ahead, over a box of rays: `ray` is a way out of a light wall, all of
/// whose states pass the bridge and touch the wall ahead at a distance x behind its corner. Nothing if that,
/// or that they turn back, is not certain; `leaves` is set if all of them touch it and go on over its peak
/// (L1).
///
/// x increases with the height c at that corner and with the slope, the reflected slope (2) of L4 increases
/// with the slope and decreases with w = cos x (L5).
template <class I>
[[nodiscard]] std::optional<Outbound<I>> off_the_light_wall(const Outbound<I>& ray, const I& r,
                                                            bool& leaves) {
    leaves = false;
    const I c = ray.height + ray.slope * pi<I>();
    if (!certainly_positive(c) || !certainly_less(ray.slope, I(1))) {
        return std::nullopt;
    }
    const auto least = lowest_contact(low_end(c), low_end(ray.slope));
    const auto greatest = highest_contact(high_end(c), high_end(ray.slope));
    if (!least || !greatest) {
        return std::nullopt;
    }
    const auto whole = reflect_at_light_wall(ray.slope, hull(greatest->cos_x, least->cos_x), r);
    leaves = certainly_at_most(whole.denominator, I(0));
    if (!certainly_positive(whole.denominator)) {
        return std::nullopt;
    }
    const auto low = reflect_at_light_wall(low_end(ray.slope), least->cos_x, r);
    const auto high = reflect_at_light_wall(high_end(ray.slope), greatest->cos_x, r);
    const I rise = hull(low.numerator / low.denominator, high.numerator / high.denominator);
    const I x = hull(least->x, greatest->x);
    return Outbound<I>{-ray.direction, ray.corner + ray.direction, x,
                       hull(least->sin_x, greatest->sin_x) + rise * x, rise};
}

/// Steps from wall to wall before the monotone counts take over.
inline constexpr long most_steps = 1000;

/// The collisions behind a contact of `left`: by the monotone counts, if necessary after some steps from wall
/// to wall.
template <class I>
[[nodiscard]] LaterCount collisions_behind(Outbound<I> ray, const I& r, Mass left) {
    for (long steps = 0;; ++steps) {
        LaterCount later = certainly_at_most(I(1), ray.slope) ? LaterCount{0, 0}  // L3
                                                              : later_collisions(ray, r, left);
        later.least += steps;
        if (later.most) {
            *later.most += steps;
        }
        if (later.exact() || left == Mass::heavy || steps == most_steps) {
            return later;
        }
        const bool passes = certainly_passes_bridge(ray, r);
        bool leaves = false;
        const auto next = passes ? off_the_light_wall(ray, r, leaves) : off_the_bridge(ray, r);
        if (leaves) {
            return {steps + 1, steps + 1};
        }
        if (!next) {
            return later;
        }
        ray = *next;
        left = passes ? Mass::light : Mass::heavy;
    }
}

/// The collisions behind the first contact, with `mass` at a time in `times`, of falling states (yhatdot < 0)
/// in the air.
template <class I>
[[nodiscard]] LaterCount collisions_behind_first(const State<I>& s, Mass mass, const I& times) {
    const I phi = contact_angle(s, mass, times);
    const SinCos<I> at = sin_cos(phi);
    const FallingReflection reflection{mass == Mass::light};
    const I m = s.phidot / -s.yhatdot;
    const I denominator = reflection.denominator(m, at.cos, s.r);
    const bool right = certainly_positive(denominator);
    if (!right && !certainly_positive(-denominator)) {
        return {};
    }
    const Way way = way_out(phi, hump_of(phi), mass, right);
    if (way != Way::inward) {
        return way == Way::outward ? LaterCount{0, 0} : LaterCount{};
    }
    const I yhat = mass == Mass::light ? -at.sin : s.r * at.sin;
    return collisions_behind(outbound(phi, yhat, reflection.slopes(m, at.cos, s.r), right), s.r, mass);
}

}  // namespace dumbbell
