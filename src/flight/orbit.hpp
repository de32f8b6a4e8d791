#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "flight/chart.hpp"

namespace dumbbell::flight {

/// One collision of an orbit, enclosed, in physical terms: rod length 1, phi in radians (0: heavy mass to the
/// right of ... as in the source paper: y1 = y + beta2 sin phi is the light mass's height), y the height of
/// the centre of mass. Time is counted from the first collision, in the unit in which phidot^2 + q (ydot /
/// beta2)^2 = 1 (this is constant; it fixes the energy). grazing_sine is the sine, in the kinetic metric, of
/// the angle between flight and wall: 0 for a tangential contact.
template <class I>
struct Collision {
    bool heavy;
    I time;
    I phi;
    I y;
    I ydot_before, ydot_after;
    I phidot_before, phidot_after;
    I grazing_sine;
};

/// A contact with the bridge (chart bridge) from which `forward` later and `backward` earlier collisions are
/// certain.
template <class I>
struct BridgeContact {
    I e;
    I eta;
    long forward;
    long backward;
};

/// Encloses all 1 + forward + backward collisions and shows them one after the other, so that an orbit of any
/// length takes no memory: the contact, the later ones, the earlier ones back in time; times are counted from
/// the contact. False if a collision cannot be enclosed, after some were shown. For every mass ratio of the
/// range.
template <class I>
[[nodiscard]] bool visit_orbit(const BridgeContact<I>& contact, const RatioRange<I>& range,
                               const std::function<void(const Collision<I>&)>& see);

/// Encloses all 1 + forward + backward collisions in the order of time, for every mass ratio of the range.
/// Nothing if a collision cannot be enclosed (the counts were not certain, or the range is too wide).
template <class I>
[[nodiscard]] std::optional<std::vector<Collision<I>>> enclose_orbit(const BridgeContact<I>& contact,
                                                                     const RatioRange<I>& range);

}  // namespace dumbbell::flight
