#pragma once

#include "file/limits.hpp"
#include "flight/certain_count.hpp"
#include "flight/corner.hpp"
#include "starts/walls/later_count.hpp"

/// Bounds of the number of collisions of bodies, as long as no corner is met: lemmas L71, L72, L74, L77, L84.
namespace dumbbell::starts {

/// No motion of the body in a plane has more collisions: L84 (a), and L72 (a) of symmetric ones.
[[nodiscard]] inline std::optional<long> most_collisions_of_body(const Rational& q, const Rational& rho) {
    const long turns = flight::corner_count(1, q, most_in_corner);
    return turns > most_in_corner ? std::nullopt : std::optional(rho == 1 ? turns : turns + 2);
}

/// The later collisions of a box of flights inward from a contact of `left` at the height yhat: at most those
/// that plain intervals cannot exclude, and at least those that are certain.
template <class S, class I>
[[nodiscard]] LaterCount body_collisions_behind(const Outbound<S>& d, const I& yhat,
                                                const flight::Body<I>& body, flight::End left) {
    constexpr long cap = 1000, most_steps = 2000;
    const Interrupted too_long = [steps = 0L]() mutable { return ++steps > most_steps; };
    const I slope = range(d.slope), kappa = flight::detail::in_play(slope);
    long least = 0, most = 0;
    if (left == flight::End::heavy) {
        const I height = range(d.height);
        least = certain_count(flight::PlainRay<I>{height, slope}, body, cap);
        most = plain_count(flight::PlainRay<I>{height, kappa}, body, cap, too_long);
    } else {
        const I x = max(I(0), min(half_pi<I>(), range(d.run))), sine = max(I(0), min(I(1), yhat));
        least = certain_later_collisions(flight::PlainDeparture<I>{x, sine, slope}, body, cap);
        most = plain_later_collisions(flight::PlainDeparture<I>{x, sine, kappa}, body, cap, too_long);
    }
    return {least, most > cap ? std::nullopt : std::optional(most)};
}

/// The later collisions of states that leave a contact of `left`, of any body.
template <class S>
[[nodiscard]] LaterCount later_collisions(const State<S>& s, flight::End left,
                                          const Interrupted& interrupted) {
    bool leaves = certainly_too_steep(s);
    const auto d = leaves ? std::nullopt : outbound(s, left, leaves);
    if (leaves) {
        return {0, 0};
    }
    if (!s.body.is_massless) {
        const auto all = ranges_of(s);
        return d ? body_collisions_behind(*d, all.yhat, all.body, left) : LaterCount{};
    }
    return d ? later_collisions(*d, s.body.r, left, interrupted)
             : LaterCount{0, left == flight::End::heavy
                                 ? most_later_collisions(range(s.body.r), count_cap, interrupted)
                                 : std::nullopt};
}

}  // namespace dumbbell::starts
