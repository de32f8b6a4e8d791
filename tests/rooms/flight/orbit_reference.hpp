#pragma once

#include <algorithm>
#include <vector>

#include "attacks/oracle/chart.hpp"
#include "attacks/oracle/scalar.hpp"
#include "reference.hpp"

namespace dumbbell_test {

/// A collision as flight/orbit.hpp has it, in 80 digits.
struct Event {
    using Real = dumbbell_oracle::Digits80;
    bool heavy;
    Real time, phi, y, ydot_before, ydot_after, phidot_before, phidot_after, grazing_sine;
};

/// The collisions of the simulated orbit (tests/attacks/oracle) through the chart-bridge state (e, eta), at
/// most the given numbers after and before, in the unit of time in which the kinetic norm is 1.
inline std::vector<Event> orbit_through(const Real& e, const Real& eta, const Real& r, std::size_t forward,
                                        std::size_t backward) {
    using S = Event::Real;
    const dumbbell_oracle::Dumbbell<S> body(1 / S(r));
    const auto contact = contact_of(body, dumbbell_oracle::BridgeState<S>{S(e), S(eta)});
    const auto all = whole_trajectory(body, contact, backward > 0, forward > 0);
    const auto turning = std::find_if(all.begin(), all.end(), [](const auto& c) { return c.time >= 0; });
    const auto first =
        turning - std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(backward), turning - all.begin());
    const auto last =
        turning + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(forward) + 1, all.end() - turning);
    const S norm = sqrt(body.twice_energy(contact.after) / body.inertia());
    std::vector<Event> events;
    for (auto c = first; c != last; ++c) {
        events.push_back({c->mass == dumbbell_oracle::Mass::heavy, (c->time - first->time) * norm,
                          c->before.phi, c->before.y, c->before.ydot / norm, c->after.ydot / norm,
                          c->before.phidot / norm, c->after.phidot / norm,
                          body.grazing_sine(c->mass, c->before)});
    }
    return events;
}

}  // namespace dumbbell_test
