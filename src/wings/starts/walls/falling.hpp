#pragma once

#include <optional>

#include "flight/contact_range.hpp"
#include "flight/reflection.hpp"
#include "starts/air/first_flight.hpp"
#include "starts/air/flight.hpp"
#include "starts/walls/body_count.hpp"
#include "starts/walls/later_count.hpp"

/// The first collision of a dumbbell in the air and what comes after it, over a box of states, in closed
/// forms that lose little of the correlations and that a verifier can repeat (format-initial.md, sections 5
/// and 6).
namespace dumbbell::starts {

/// The least roots x in [0, pi] of sin x = c + kappa x, for all c and kappa of these intervals: all contacts
/// of a box of rays from a light wall with the bridge ahead, before its top or behind it. Nothing unless it
/// is certain that all of them have one and that sin x - kappa x still rises there: L60.
template <class I>
[[nodiscard]] std::optional<flight::ContactRange<I>> bridge_contacts(const I& c, const I& kappa) {
    const auto guess = [](const I& height, const I& slope) {
        I z(flight::guess_bridge_contact(approximate(height), approximate(slope), 1));
        for (int bits = 53; bits < PrecisionScope::current(); bits *= 2) {
            const SinCos<I> at = sin_cos(z);
            z = midpoint(z - (at.sin - slope * z - height) / (at.cos - slope));
        }
        return z;
    };
    const I near = guess(low_end(c), low_end(kappa));
    const I far = guess(high_end(c), high_end(kappa));
    if (!certainly_positive(c) || !certainly_at_most(I(0), near) || !certainly_at_most(near, pi<I>())) {
        return std::nullopt;
    }
    const auto value = [](const I& x, const I& height, const I& slope) {
        return sin_cos(x).sin - slope * x - height;
    };
    const I rate = sin_cos(near).cos - low_end(kappa);
    const I rate_far = sin_cos(far).cos - high_end(kappa);
    if (!certainly_positive(rate) || !certainly_positive(rate_far)) {
        return std::nullopt;
    }
    const I least = low_end(max(I(0), near - value(near, low_end(c), low_end(kappa)) / rate));  // L60 (a)
    const I residual = magnitude(value(far, high_end(c), high_end(kappa)) / rate_far);
    for (const int factor : {2, 8, 64}) {
        const I greatest = high_end(far + residual * I(factor));
        if (certainly_at_most(least, greatest) && certainly_at_most(greatest, pi<I>()) &&
            certainly_positive(value(greatest, high_end(c), high_end(kappa)))) {  // L60 (b)
            const I x = hull(least, greatest);
            return flight::ContactRange<I>{x, sin_cos(x)};
        }
    }
    return std::nullopt;
}

/// The angle phi at which `end` touches, for all states of the box, all of whose contacts lie in `times`.
///
/// The mean value form of phi' = phi + phidot T. With N = N.v the rate of the clearance at the contact (N < 0
/// on `times`), implicit differentiation of clearance(T) = 0 gives d phi'/d phi = yhatdot / N, d phi'/d
/// phidot = T yhatdot / N, d phi'/d yhat = -phidot / N, d phi'/d yhatdot = -phidot T / N and d phi'/d r = 0
/// (light), phidot sin phi' / N (heavy).
template <class I>
[[nodiscard]] I contact_angle(const State<I>& s, flight::End end, const I& times) {
    const I natural = s.phi + s.phidot * times;
    const State<I> m = detail::middle_of(s);
    const I t = midpoint(times);
    const I centre = intersection(times, t - clearance(m, end, t) / clearance_rate(m, end, times));
    const I rate = clearance_rate(s, end, times);
    I change = s.yhatdot * ((s.phi - m.phi) + times * (s.phidot - m.phidot)) -
               s.phidot * ((s.yhat - m.yhat) + times * (s.yhatdot - m.yhatdot));
    if (end == flight::End::heavy) {
        change = change + s.phidot * sin_cos(natural).sin * (s.body.rho - m.body.rho);
    }
    return intersection(natural, m.phi + m.phidot * centre + change / rate);
}

/// The slope d yhat / d phi after the first contact, at the angle phi, of states whose velocities are in a
/// certain half plane: of falling states (yhatdot < 0) from m = phidot / -yhatdot, else, with phidot of one
/// sign, from n = yhatdot / phidot. With c = cos phi, (1) of L0 gives the slope as a quotient
///   light: (r - c^2 - 2 r c m) / (m (r - c^2) + 2 c)      = (n (c^2 - r) - 2 r c) / (r - c^2 - 2 n c),
///   heavy: (1 - r c^2 + 2 r c m) / (m (1 - r c^2) - 2 c)  = (n (r c^2 - 1) + 2 r c) / (1 - r c^2 + 2 n c),
/// the denominator having the sign of phidot' (times that of phidot). Where it keeps its sign the quotient
/// decreases with m or n, and decreases (light) or increases (heavy) with c: the numerators of its
/// derivatives are -(c^2 + r)^2 or -(1 + r c^2)^2, and -+2 (1 + r m^2) or -+2 (n^2 + r), times c^2 + r or
/// 1 + r c^2. Of a body the heavy end's 1 + r c^2 and 1 - r c^2 are g + rho c^2 and g - rho c^2 (L77).
struct FirstReflection {
    flight::End end;
    bool falling;

    template <class I>
    [[nodiscard]] flight::LightReflection<I> at(const I& x, const I& c, const flight::Body<I>& body) const {
        if (!falling) {
            return reflect_at_end(end, x, c, body);
        }
        const I rest = body.weight(end) - body.leveraged(end, sqr(c));
        return {rest - turned(end, I(2) * body.r * c) * x, x * rest + turned(end, I(2) * c)};
    }
    /// Over all x (m or n) and c of these intervals, from two opposite ends. Precondition: the denominator
    /// keeps its sign.
    template <class I>
    [[nodiscard]] I slopes(const I& x, const I& c, const flight::Body<I>& body) const {
        const bool light = end == flight::End::light;
        const auto low = at(high_end(x), light ? high_end(c) : low_end(c), body);
        const auto high = at(low_end(x), light ? low_end(c) : high_end(c), body);
        return hull(low.numerator / low.denominator, high.numerator / high.denominator);
    }
};

/// What a ray does that meets the bridge, over a box of rays: `ray` is a way out of a light wall, all of
/// whose states touch the bridge at a distance x in [0, pi] behind the corner. Nothing if that, or the
/// direction after it, is not certain.
template <class I>
[[nodiscard]] std::optional<Outbound<I>> off_the_bridge(const Outbound<I>& ray, const flight::Body<I>& body) {
    const I& r = body.rho;
    const auto at = bridge_contacts(ray.height / r, ray.slope / r);
    if (!at) {
        return std::nullopt;
    }
    const FirstReflection reflection{flight::End::heavy, false};
    const I onward = reflection.at(ray.slope, at->at.cos, body).denominator;
    const bool back = certainly_positive(-onward);
    if (!back && !certainly_positive(onward)) {
        return std::nullopt;
    }
    const I along = reflection.slopes(ray.slope, at->at.cos, body);
    const I run = back ? at->x : pi<I>() - at->x;
    const I rise = back ? -along : along;
    return Outbound<I>{back ? -ray.direction : ray.direction, ray.corner + (back ? 0 : ray.direction), run,
                       r * at->at.sin + rise * run, rise};
}

/// What a ray does at the light wall ahead, over a box of rays: `ray` is a way out of the bridge, or of a
/// light wall past the bridge, all of whose states touch the wall ahead at a distance x behind its corner.
/// Nothing if that, or that they turn back, is not certain; `leaves` is set if all of them touch it and go on
/// over its peak (L1).
///
/// x increases with the height c at that corner and with the slope, the reflected slope (2) of L4 increases
/// with the slope and decreases with w = cos x, however steeply the ray falls (L60 (d)).
template <class I>
[[nodiscard]] std::optional<Outbound<I>> off_the_light_wall(const Outbound<I>& ray, const I& r,
                                                            flight::End left, bool& leaves) {
    leaves = false;
    const bool over_bridge = left == flight::End::light;
    const I c = over_bridge ? ray.height + ray.slope * pi<I>() : ray.height;
    if (!certainly_positive(c) || !certainly_less(ray.slope, I(1))) {
        return std::nullopt;
    }
    const auto least = flight::lowest_contact(low_end(c), low_end(ray.slope));
    const auto greatest = flight::highest_contact(high_end(c), high_end(ray.slope));
    if (!least || !greatest) {
        return std::nullopt;
    }
    const auto whole = flight::reflect_at_light_wall(ray.slope, hull(greatest->cos_x, least->cos_x), r);
    leaves = certainly_at_most(whole.denominator, I(0));
    if (!certainly_positive(whole.denominator)) {
        return std::nullopt;
    }
    const auto low = flight::reflect_at_light_wall(low_end(ray.slope), least->cos_x, r);
    const auto high = flight::reflect_at_light_wall(high_end(ray.slope), greatest->cos_x, r);
    const I rise = hull(low.numerator / low.denominator, high.numerator / high.denominator);
    const I x = hull(least->x, greatest->x);
    return Outbound<I>{-ray.direction, ray.corner + (over_bridge ? ray.direction : 0), x,
                       hull(least->sin_x, greatest->sin_x) + rise * x, rise};
}

/// Steps from wall to wall, and those of them from rays that the monotone counts bound (kappa >= -r), after
/// which nothing more is looked for.
inline constexpr long most_steps = 1000;
inline constexpr long most_counted_steps = 64;

/// The collisions after a contact of `left`: by the monotone counts, if necessary after some steps from wall
/// to wall; the best bounds of all steps, or of those before an interruption.
template <class I>
[[nodiscard]] LaterCount collisions_behind(Outbound<I> ray, const flight::Body<I>& body, flight::End left,
                                           const Interrupted& interrupted) {
    const I& r = body.r;
    LaterCount best;
    long counted = 0;
    for (long steps = 0;; ++steps) {
        const LaterCount later = certainly_at_most(I(1), ray.slope)
                                     ? LaterCount{0, 0}  // L3
                                     : later_collisions(ray, r, left, interrupted);
        best.least = std::max(best.least, steps + later.least);
        if (later.most && (!best.most || steps + *later.most < *best.most)) {
            best.most = steps + *later.most;
        }
        counted += certainly_at_most(-low_end(r), ray.slope) ? 1 : 0;
        if (best.exact() || steps == most_steps || counted > most_counted_steps || interrupted()) {
            return best;
        }
        const bool to_wall = left == flight::End::heavy || certainly_passes_bridge(ray, r);
        bool leaves = false;
        const auto next = to_wall ? off_the_light_wall(ray, r, left, leaves) : off_the_bridge(ray, body);
        if (leaves) {
            return {steps + 1, steps + 1};
        }
        if (!next) {
            return best;
        }
        ray = *next;
        left = to_wall ? flight::End::light : flight::End::heavy;
    }
}

/// The collisions after the first contact, with `end` at a time in `times`, of states in the air. Nothing
/// is certain unless they fall, or turn in one direction.
template <class I>
[[nodiscard]] LaterCount collisions_behind_first(const State<I>& s, flight::End end, const I& times,
                                                 const Interrupted& interrupted = never) {
    const bool falling = certainly_positive(-s.yhatdot);
    const bool backwards = certainly_positive(-s.phidot);
    if (!falling && !backwards && !certainly_positive(s.phidot)) {
        return {};
    }
    const I phi = contact_angle(s, end, times);
    const SinCos<I> at = sin_cos(phi);
    const FirstReflection reflection{end, falling};
    const I x = falling ? s.phidot / -s.yhatdot : s.yhatdot / s.phidot;
    const auto [rise, denominator] = reflection.at(x, at.cos, s.body);
    if (certainly_at_most(magnitude(denominator), !falling && backwards ? -rise : rise)) {
        return {0, 0};  // L3, whatever the direction
    }
    const bool positive = certainly_positive(denominator);
    if (!positive && !certainly_positive(-denominator)) {
        return {};
    }
    const bool right = positive != (!falling && backwards);
    const Way way = way_out(phi, hump_of(phi), end, right);
    if (way != Way::inward) {
        return way == Way::outward ? LaterCount{0, 0} : LaterCount{};
    }
    const I yhat = s.body.contact_height(end, at.sin);
    const auto ray = outbound(phi, yhat, reflection.slopes(x, at.cos, s.body), right);
    return s.body.is_massless ? collisions_behind(ray, s.body, end, interrupted)
                              : body_collisions_behind(ray, yhat, s.body, end);
}

}  // namespace dumbbell::starts
