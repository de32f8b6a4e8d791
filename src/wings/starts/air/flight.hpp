#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "flight/bridge_contact.hpp"
#include "flight/contact.hpp"
#include "starts/air/contact_time.hpp"

/// Which contact ends a flight that begins at a contact: proofs for a whole box of states (lemmas L1-L4, L6).
namespace dumbbell::starts {

/// What is certain of the next event of every state in a box.
enum class Next {
    contact,  ///< each collides next with `end`, `time` from now
    none,     ///< none ever collides again
    unknown
};

template <class S>
struct Event {
    Next next = Next::unknown;
    flight::End end = flight::End::light;
    std::optional<S> time{};
};

/// A flight away from a contact, towards the walls ahead: it passes the corner ahead at height `height`,
/// where the distance `run` of the angle is done, and rises by `slope` per radian.
template <class S>
struct Outbound {
    int direction;  ///< sign of phidot
    long corner;    ///< the corner's angle, in units of pi
    S run;
    S height;
    S slope;
};

/// Lemma L3: every state ascends with slope >= 1 and leaves (a vertical one too).
template <class S>
[[nodiscard]] bool certainly_too_steep(const State<S>& s) {
    const auto& spin = range(s.phidot);
    const auto& climb = range(s.yhatdot);
    return certainly_positive(climb) && certainly_at_most(magnitude(spin), climb);
}

/// Where a flight goes that leaves a contact of `left` at the angle phi to the right or left.
enum class Way { inward, outward, unknown };

/// `inward`: towards the walls ahead in the same cell: from the bridge, always; from a light wall, away from
/// the wall's peak. `outward`: over the wall's peak (lemma L1: never again).
template <class I>
[[nodiscard]] Way way_out(const I& phi, long hump, flight::End left, bool right) {
    const I begin = pi<I>() * I(static_cast<double>(hump));
    const I end = pi<I>() * I(static_cast<double>(hump + 1));
    if (!certainly_less(begin, phi) || !certainly_less(phi, end)) {
        return Way::unknown;
    }
    if (left == flight::End::heavy) {
        return Way::inward;
    }
    const I peak = begin + half_pi<I>();
    const bool before = certainly_at_most(phi, peak);
    const bool behind = certainly_at_most(peak, phi);
    return !(before || behind) ? Way::unknown : right == before ? Way::outward : Way::inward;
}

/// The hump (k pi, (k + 1) pi) of the floor that an angle seems to lie on; 0 if the angle is no number, or
/// too large for its hump to be counted in doubles.
template <class I>
[[nodiscard]] long hump_of(const I& phi) {
    constexpr double most = std::numeric_limits<long>::digits > 53 ? 0x1p53 : 0x1p30;
    const double turns = std::floor(approximate(phi) / std::numbers::pi);
    return std::abs(turns) < most ? static_cast<long>(turns) : 0;
}

/// The way inward from a contact at the angle phi and height yhat, with the slope d yhat / d phi after it.
template <class S>
[[nodiscard]] Outbound<S> outbound(const S& phi, const S& yhat, const S& slope, bool right) {
    using I = Enclosure<S>;
    const long corner = hump_of(range(phi)) + (right ? 1 : 0);
    const S at(pi<I>() * I(static_cast<double>(corner)));
    const S run = right ? at - phi : phi - at;
    const S rise = right ? slope : -slope;
    return {right ? 1 : -1, corner, run, yhat + rise * run, rise};
}

/// The way out of the contact of `left`, if it is certainly one inward; `leaves` is set if it is certainly
/// outward.
template <class S>
[[nodiscard]] std::optional<Outbound<S>> outbound(const State<S>& s, flight::End left, bool& leaves) {
    leaves = false;
    const bool right = certainly_positive(range(s.phidot));
    if (!right && !certainly_positive(-range(s.phidot))) {
        return std::nullopt;
    }
    const Way way = way_out(range(s.phi), hump_of(range(s.phi)), left, right);
    leaves = way == Way::outward;
    return way == Way::inward ? std::optional(outbound(s.phi, s.yhat, s.yhatdot / s.phidot, right))
                              : std::nullopt;
}

/// The flight passes the bridge ahead without touching it: height + slope x > r sin x on [0, pi], from the
/// tangent of the concave sine at a point z; the affine difference is positive at both ends.
template <class S>
[[nodiscard]] bool certainly_passes_bridge(const Outbound<S>& d, const S& r) {
    using I = Enclosure<S>;
    if (certainly_at_most(range(r), low_end(range(d.slope)))) {
        return true;  // L1: the height at the corner is positive, and the bridge is nowhere steeper than r
    }
    const double ratio = approximate(range(d.slope)) / approximate(range(r));
    const I z(std::acos(std::fmin(1.0, std::fmax(-1.0, ratio))));
    const SinCos<I> at = sin_cos(z);
    const S near = d.height - r * S(at.sin - z * at.cos);
    const S far = d.height + d.slope * S(pi<I>()) - r * S(at.sin + (pi<I>() - z) * at.cos);
    return certainly_positive(range(near)) && certainly_positive(range(far));
}

/// The contact `x` (radians) behind a corner, proved: a contact of `end` with the angle certainly within [0,
/// `extent`] of that corner. There the clearance is a convex function of time, positive at the corner, so
/// this contact is the first one.
template <class S>
[[nodiscard]] Event<S> contact_behind_corner(const State<S>& s, const Outbound<S>& d, long corner,
                                             flight::End end, const Enclosure<S>& x,
                                             const Enclosure<S>& extent) {
    using I = Enclosure<S>;
    const I offset = pi<I>() * I(static_cast<double>(corner));
    const I angle = offset + I(d.direction) * x;
    const auto time =
        contact_time(s, end, midpoint((angle - midpoint(range(s.phi))) / midpoint(range(s.phidot))));
    if (!time) {
        return {};
    }
    const I behind = I(d.direction) * (range(s.phi + s.phidot * *time) - offset);
    if (!certainly_positive(behind) || !certainly_less(behind, extent) || !certainly_positive(range(*time))) {
        return {};
    }
    return {Next::contact, end, time};
}

/// The next event of states that leave a contact of `left` (bounce().after).
template <class S>
[[nodiscard]] Event<S> event_after_contact(const State<S>& s, flight::End left) {
    using I = Enclosure<S>;
    bool leaves = certainly_too_steep(s);
    const auto d = leaves ? std::nullopt : outbound(s, left, leaves);
    if (leaves) {
        return {Next::none};
    }
    if (!d) {
        return {};
    }
    S c = d->height;  // at the corner before the light wall ahead
    long corner = d->corner;
    if (left == flight::End::light) {
        if (!certainly_passes_bridge(*d, s.body.rho)) {
            const double x = flight::guess_bridge_contact(
                approximate(range(d->height)), approximate(range(d->slope)), approximate(range(s.body.rho)));
            return contact_behind_corner(s, *d, corner, flight::End::heavy, I(x), pi<I>());
        }
        c = c + d->slope * S(pi<I>());
        corner += d->direction;
    }
    // c > 0: the bridge is cleared, or left. All collisions lie in one cell (L2 (b)): only
    // the light wall up to its peak is left.
    const flight::ContactGuess<I> guess =
        flight::guess_contact(midpoint(range(c)), midpoint(range(d->slope)));
    if (guess.hits) {
        return contact_behind_corner(s, *d, corner, flight::End::light, guess.z, half_pi<I>());
    }
    const SinCos<I> at = sin_cos(guess.z);
    const S near = c - S(at.sin - guess.z * at.cos);
    const S far = c + d->slope * S(half_pi<I>()) - S(at.sin + (half_pi<I>() - guess.z) * at.cos);
    const bool miss = certainly_positive(range(near)) && certainly_positive(range(far));  // L12 (c)
    return miss ? Event<S>{Next::none} : Event<S>{};
}

}  // namespace dumbbell::starts
