#pragma once

#include <algorithm>
#include <vector>

#include "attacks/oracle/chart.hpp"
#include "attacks/oracle/scalar.hpp"
#include "flight/orbit.hpp"
#include "reference.hpp"
#include "rooms/number/show.hpp"

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

/// The names of what is not enclosed.
template <class I>
std::string escaped(const dumbbell::flight::Collision<I>& ours, const Event& exact) {
    std::string names;
    const auto check = [&](const char* name, const I& x, const Event::Real& v) {
        if (!encloses(x, v)) {
            names += say(name, v, "not in", x);
        }
    };
    check("time", ours.time, exact.time);
    check("phi", ours.phi, exact.phi);
    check("y", ours.y, exact.y);
    check("ydot before", ours.ydot_before, exact.ydot_before);
    check("ydot after", ours.ydot_after, exact.ydot_after);
    check("phidot before", ours.phidot_before, exact.phidot_before);
    check("phidot after", ours.phidot_after, exact.phidot_after);
    check("grazing sine", ours.grazing_sine, exact.grazing_sine);
    return names;
}

}  // namespace dumbbell_test
