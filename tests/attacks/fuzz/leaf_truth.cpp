#include "leaf_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "attacks/oracle/chart.hpp"
#include "attacks/oracle/simulate.hpp"
#include "collisions/chart.hpp"
#include "collisions/names.hpp"
#include "target.hpp"

namespace dumbbell_fuzz {
namespace {

using dumbbell::collisions::Chart, dumbbell::collisions::Reason;
using dumbbell_oracle::BridgeState, dumbbell_oracle::Contact, dumbbell_oracle::Dumbbell,
    dumbbell_oracle::LightState, dumbbell_oracle::Mass, dumbbell_oracle::Total;
using Body = Dumbbell<Real>;

constexpr Real doubt = 1e-8L;
constexpr Real pi = std::numbers::pi_v<Real>;

bool between(Real lo, Real x, Real hi) { return lo + doubt < x && x < hi - doubt; }

/// The whole trajectory, if there is no doubt about it.
std::optional<Total<Real>> whole(const Body& body, const Contact<Real>& contact) {
    const auto total = dumbbell_oracle::total_collisions(body, contact);
    return total.care.doubtful() ? std::nullopt : std::optional(total);
}

std::optional<Seen> future(const Body& body, const Contact<Real>& contact) {
    const auto run = dumbbell_oracle::simulate(body, contact.after, contact.mass);
    if (run.care.doubtful()) return std::nullopt;
    const bool heavy = std::any_of(run.collisions.begin(), run.collisions.end(),
                                   [](const auto& c) { return c.mass == Mass::heavy; });
    return Seen{static_cast<long>(run.collisions.size()), heavy};
}

/// Lemma L8: contacts with the bridge whose ray goes left with a slope below 1.
std::optional<Seen> at_bridge(const Body& body, const ChartState& s, bool both_ways) {
    if (!between(0, s.position, both_ways ? pi / 2 : pi) || s.slope < doubt ||
        (std::cos(s.position) + s.slope) / s.ratio > 1 - doubt)
        return std::nullopt;
    const auto contact = contact_of(body, BridgeState<Real>{s.position, s.slope});
    if (!both_ways) return future(body, contact);
    const auto total = whole(body, contact);
    return total ? std::optional(Seen{static_cast<long>(total->collisions), false}) : std::nullopt;
}

/// Lemma L9: turning collisions of trajectories that never touch the bridge.
std::optional<Seen> at_light_wall(const Body& body, const ChartState& s) {
    const Real w = std::cos(s.position), r = 1 / s.ratio;
    if (!between(0, s.position, pi / 2) || s.slope < doubt || r * s.slope > 1 - doubt ||
        2 * w + r * s.slope - s.slope * w * w < doubt)
        return std::nullopt;
    const auto total = whole(body, contact_of(body, LightState<Real>{s.position, s.slope}));
    if (!total || total->heavy > 0) return std::nullopt;
    return Seen{static_cast<long>(total->collisions), false};
}

/// Lemma L15 (ii): departures from a light wall in any direction to the left.
std::optional<Seen> departing(const Body& body, const ChartState& s) {
    const Real kappa = s.slope - std::cos(s.position);
    if (!between(0, s.position, pi / 2) || s.slope < doubt || kappa > 1 - doubt) return std::nullopt;
    return future(body, contact_of(body, LightState<Real>{s.position, kappa * s.ratio}));
}

}  // namespace

std::optional<Seen> simulated(Chart chart, const ChartState& state) {
    const Body body(state.ratio);
    switch (chart) {
        case Chart::bridge:
            return at_bridge(body, state, true);
        case Chart::light:
            return at_light_wall(body, state);
        case Chart::departure:
        case Chart::plain_departure:
            return departing(body, state);
        default:
            return at_bridge(body, state, false);
    }
}

void must_hold(Chart chart, const dumbbell::collisions::Leaf& leaf, const ChartState& state) {
    const auto seen = simulated(chart, state);
    if (!seen) return;
    // The other reasons say that there is no such state.
    bool holds = false;
    if (leaf.reason == Reason::count)
        holds = row_of(chart).counts_both_ways ? seen->collisions <= 1 + leaf.forward + leaf.backward
                                               : seen->collisions <= leaf.forward;
    if (leaf.reason == Reason::once) holds = !seen->heavy_again;
    if (holds) return;
    std::ostringstream text;
    text.precision(21);
    text << "an accepted leaf is wrong: chart " << row_of(chart).name << ", leaf " << name(leaf.reason) << ' '
         << leaf.forward << ' ' << leaf.backward << ", state " << state.position << ' ' << state.slope
         << ", ratio " << state.ratio << ": simulated " << seen->collisions
         << (seen->heavy_again ? ", the heavy mass again" : "");
    trap(text.str());
}

void must_hold(const dumbbell::collisions::Witness& witness, Real ratio) {
    const ChartState state{witness.e.convert_to<Real>(), witness.eta.convert_to<Real>(), ratio};
    must(state.position > 0 && state.position <= pi / 2 && state.slope > 0, "a witness is in its chart");
    const auto total =
        whole(Body(ratio), contact_of(Body(ratio), BridgeState<Real>{state.position, state.slope}));
    if (!total || witness.total() <= static_cast<long>(total->collisions)) return;
    std::ostringstream text;
    text.precision(21);
    text << "an accepted witness is wrong: " << state.position << ' ' << state.slope << ", ratio " << ratio
         << ": claims " << witness.total() << ", simulated " << total->collisions;
    trap(text.str());
}

}  // namespace dumbbell_fuzz
