#pragma once

#include "number/enclosure.hpp"

/// A body that hits the floor with its two ends, as flights know it (L0; L70 of body.md).
namespace dumbbell::flight {

/// The light end is at the distance d1 from the centre of mass, and above it at psi = 0; the heavy one at d2.
enum class End { light, heavy };

[[nodiscard]] constexpr End other(End end) { return end == End::light ? End::heavy : End::light; }

/// x at the light end, -x at the heavy one: what turns the one up turns the other down.
template <class S>
[[nodiscard]] S turned(End end, const S& x) {
    return end == End::light ? x : -x;
}

/// Bodies, by the leverages 1 and rho = d2/d1 and the weights r = 1/Q and g = r/rho of their ends: the end
/// with leverage l is at the height yhat + l sin phi (light) or yhat - l sin phi (heavy), in units of d1. rho
/// is the height of the bridge, too.
template <class S>
struct Body {
    S rho, r, g;
    bool is_massless;  ///< all mass is at the ends: Q rho = 1, so that g = 1

    /// Dumbbells with a massless rod and r = 1/q.
    [[nodiscard]] static Body massless(const S& ratio) { return {ratio, ratio, S(1), true}; }
    [[nodiscard]] static Body with_mass(const S& height, const S& ratio) {
        return {height, ratio, ratio / height, false};
    }

    [[nodiscard]] const S& weight(End end) const { return end == End::light ? r : g; }
    /// The end's weight + leverage c^2: with c = cos phi what a push at it moves, and |N|^2 over its
    /// leverage.
    [[nodiscard]] S resistance(End end, const S& c) const { return weight(end) + leveraged(end, sqr(c)); }
    /// x times the end's leverage or weight. Where that is 1 nothing is multiplied, and so nothing rounded.
    [[nodiscard]] S leveraged(End end, const S& x) const { return end == End::light ? x : rho * x; }
    [[nodiscard]] S weighted(End end, const S& x) const {
        return end == End::heavy && is_massless ? x : weight(end) * x;
    }
    /// yhat where the end touches the floor, from the sine of phi.
    [[nodiscard]] S contact_height(End end, const S& sine) const {
        return -turned(end, leveraged(end, sine));
    }
};

}  // namespace dumbbell::flight
