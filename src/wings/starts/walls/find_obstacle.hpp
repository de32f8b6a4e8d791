#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "starts/walls/follow.hpp"
#include "starts/walls/obstacle.hpp"

/// Why orbits cannot be followed any further: which events their enclosures do not exclude. This names what
/// is undecided, and decides nothing.
namespace dumbbell::starts {
namespace detail {

struct Suspicion {
    bool corner = false;
    bool graze = false;
};

/// What is closer to an event than this (in rod lengths, about) is near it: doubles lose half their digits
/// where a contact only just happens.
inline constexpr double nearness = 0x1p-26;

template <class I>
bool may_vanish(const I& x) {
    return !certainly_less(I(nearness), x) && !certainly_less(I(nearness), -x);
}

/// A line of this height and slope over the hump `size` sin x, x in [0, extent].
enum class Over { clear, hits, unknown };
template <class I>
Over over_hump(const I& height, const I& slope, const I& size, const I& extent) {
    const double steepest = approximate(slope) / approximate(size);
    const I top(std::acos(std::fmin(1.0, std::fmax(-1.0, steepest))));
    const I z = min(top, low_end(extent));
    const SinCos<I> at = sin_cos(z);
    const I gap = height + slope * z - size * at.sin;
    const I near = gap - z * (slope - size * at.cos);
    const I far = gap + (extent - z) * (slope - size * at.cos);
    return certainly_less(I(nearness), near) && certainly_less(I(nearness), far) ? Over::clear
           : certainly_less(I(nearness), -gap)                                   ? Over::hits
                                                                                 : Over::unknown;
}

template <class I>
Suspicion after_contact(const State<I>& s, flight::End left) {
    bool leaves = false;
    const auto d = outbound(s, left, leaves);
    if (!d) {
        return {};
    }
    Suspicion result;
    I c = d->height;
    result.corner = may_vanish(c);
    if (left == flight::End::light) {
        const Over bridge = over_hump(c, d->slope, s.body.rho, pi<I>());
        result.graze = bridge == Over::unknown;
        if (bridge == Over::hits) {
            return result;
        }
        c = c + d->slope * pi<I>();
        result.corner = result.corner || may_vanish(c);
    }
    result.graze = result.graze || over_hump(c, d->slope, I(1), half_pi<I>()) == Over::unknown;
    return result;
}

/// The times near which the clearance of a mass is least within a turn: the first one; of flights that seem
/// to end at `contact` those around it. In doubles.
inline std::array<double, 3> lowest_times(double phi, double phidot, double yhatdot, double amplitude,
                                          bool light, std::optional<double> contact) {
    const double cosine = -yhatdot / amplitude;
    const double period = 2 * std::numbers::pi / std::abs(phidot);
    std::array<double, 3> times{-1, -1, -1};
    if (!(std::abs(cosine) <= 1) || !std::isfinite(period)) {
        return times;
    }
    const double angle = light ? -std::acos(cosine) : std::acos(cosine);
    const double any = (angle - phi) / phidot;
    const double first = any - period * std::floor(any / period);
    const double turns = contact ? std::floor((*contact - first) / period + 0.5) : 0;
    for (int i = 0; i < 3; ++i) {
        const double time = first + period * (turns + i - 1);
        times.at(static_cast<std::size_t>(i)) = !contact || time <= *contact + period / 2 ? time : -1;
    }
    return times;
}

/// That time for the middle of the box, by Newton's iteration on the clearance's rate.
template <class I>
I lowest_time(const State<I>& middle, flight::End end, I t) {
    for (int bits = 27; bits < 2 * PrecisionScope::current(); bits *= 2) {
        const I turning = sqr(middle.phidot) * sin_cos(middle.phi + middle.phidot * t).sin;
        const I bend = turned(end, middle.body.leveraged(end, turning));
        t = midpoint(t + clearance_rate(middle, end, t) / bend);
    }
    return t;
}

template <class I>
Suspicion from_air(const State<I>& s) {
    const State<I> middle = middle_of(s);
    const double phi = approximate(s.phi), phidot = approximate(s.phidot), yhatdot = approximate(s.yhatdot);
    const double rho = approximate(s.body.rho);
    const auto guess = guess_first_contact(phi, approximate(s.yhat), phidot, yhatdot, rho);
    Suspicion result;
    if (guess) {
        I times = polished_guess(s, guess->end, I(guess->time));
        const I rate = clearance_rate(middle, guess->end, times);
        if (certainly_less(I(nearness), -rate)) {  // the contacts of the box, about
            times = hull(times, times - clearance(s, guess->end, times) / rate);
        }
        result.corner = may_vanish(clearance(s, other(guess->end), times));
    }
    for (const flight::End end : {flight::End::light, flight::End::heavy}) {
        const bool light = end == flight::End::light;
        for (const double time : lowest_times(phi, phidot, yhatdot, light ? phidot : -rho * phidot, light,
                                              guess ? std::optional(guess->time) : std::nullopt)) {
            result.graze = result.graze ||
                           (time > 0 && may_vanish(clearance(s, end, lowest_time(middle, end, I(time)))));
        }
    }
    return result;
}

inline Obstacle named(const Suspicion& found, bool may_be_flat) {
    return found.corner && found.graze ? Obstacle::corner_or_graze
           : found.corner              ? (may_be_flat ? Obstacle::flat : Obstacle::corner)
           : found.graze               ? Obstacle::graze
                                       : Obstacle::other;
}

}  // namespace detail

/// Of orbits that were followed from `start`: what their next flight is on or near to, where they are not
/// complete; else what one of their flights is, the first that is near to anything.
template <class S, class I>
[[nodiscard]] Obstacle find_obstacle(const Followed<S>& followed, const State<I>& start) {
    const auto& bounces = followed.bounces;
    Obstacle found = Obstacle::other;
    if (bounces.empty() || followed.complete()) {
        found = detail::named(detail::from_air(start), detail::may_vanish(start.phidot));
    }
    for (std::size_t i = followed.complete() ? 0 : std::max<std::size_t>(bounces.size(), 1) - 1;
         i < bounces.size() && found == Obstacle::other; ++i) {
        found = detail::named(detail::after_contact(ranges_of(bounces[i].after), bounces[i].end), false);
    }
    return found;
}

}  // namespace dumbbell::starts
