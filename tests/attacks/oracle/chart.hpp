// The charts of format.md and the physical states they stand for.
//
//     psi = phi - pi/2,  yhat = y / beta2,  slope = d yhat / |d psi|,  one cell: psi in [-pi, pi]
//
// e is the corner distance of a contact: |psi| = pi/2 - e on the bridge, pi/2 + e on a light wall.
#pragma once

#include <optional>

#include "simulate.hpp"

namespace dumbbell_oracle {

// Contact with the bridge at psi = pi/2 - e; the ray X leaves to the left with slope (cos e + eta) / q.
template <class S>
struct BridgeState {
    S e;
    S eta;
};

// Contact with the wall R at psi = pi/2 + e; the ray X leaves to the left with slope lambda / q.
template <class S>
struct LightState {
    S e;
    S lambda;
};

template <class S>
[[nodiscard]] Contact<S> contact_of(const Dumbbell<S>& body, const BridgeState<S>& state);
template <class S>
[[nodiscard]] Contact<S> contact_of(const Dumbbell<S>& body, const LightState<S>& state);

template <class S>
[[nodiscard]] S psi_of(const State<S>& state);
template <class S>
[[nodiscard]] S slope_of(const Dumbbell<S>& body, const State<S>& state);  // not finite for a vertical ray

enum class Wall { left, bridge, right };

// Where a contact lies: which cell (psi in [(2 cell - 1) pi, (2 cell + 1) pi]), wall, corner distance.
template <class S>
struct Place {
    long cell;
    Wall wall;
    int side;  // sign of psi in the cell
    S e;
};
template <class S>
[[nodiscard]] Place<S> place_of(Mass mass, const State<S>& state);

// Chart coordinates of a collision, using the mirror (psi -> -psi) and the reversal (sigma) as needed;
// nothing if neither way leaves the contact to the left. For the light chart the contact must be a turning
// collision (ydot <= 0 before, >= 0 after), or there is nothing either.
template <class S>
[[nodiscard]] std::optional<BridgeState<S>> bridge_state_of(const Dumbbell<S>& body,
                                                            const Collision<S>& collision);
template <class S>
[[nodiscard]] std::optional<LightState<S>> light_state_of(const Dumbbell<S>& body,
                                                          const Collision<S>& collision);

}  // namespace dumbbell_oracle
