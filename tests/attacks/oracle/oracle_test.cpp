// The simulation itself, and lemmas L0-L3 on simulated trajectories.
#include <algorithm>

#include "catch.hpp"
#include "chart.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

// Law (1) of proofs/lemmas.md in (psi, yhat), with the wall slope t.
State<Real> bounce_by_law1(const Dumbbell<Real>& body, Mass mass, const State<Real>& state) {
    const Real r = 1 / body.ratio();
    const Real psi = psi_of(state);
    const Real t = mass == Mass::light ? std::sin(psi) : -r * std::sin(psi);
    const Real yhatdot = state.ydot / body.beta2();
    const Real push = 2 * (yhatdot - t * state.phidot) / (t * t + r);
    State<Real> after = state;
    after.phidot = state.phidot + push * t;
    after.ydot = (yhatdot - push * r) * body.beta2();
    return after;
}

// In the kinetic metric, relative to the speed.
Real distance(const Dumbbell<Real>& body, const State<Real>& a, const State<Real>& b) {
    const State<Real> difference{0, a.phidot - b.phidot, 0, a.ydot - b.ydot};
    return std::sqrt(body.twice_energy(difference) / body.twice_energy(a));
}

// Empty if the trajectory is as L1, L2, L3 and L6 say; else what is wrong.
std::string broken_rule(const Dumbbell<Real>& body, const std::vector<Collision<Real>>& all) {
    const Real r = 1 / body.ratio();
    std::size_t turning = 0;
    std::size_t bridge = 0;
    const Place<Real> first = place_of(all.front().mass, all.front().after);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Collision<Real>& now = all[i];
        const Place<Real> place = place_of(now.mass, now.after);
        if (!(now.after.ydot > now.before.ydot)) return say("L2 (a): ydot does not grow at collision", i);
        if (place.cell != first.cell) return say("L2 (b): leaves the cell at collision", i);
        turning += now.before.ydot <= 0 && now.after.ydot >= 0;
        bridge += now.mass == Mass::heavy;
        if (i + 1 == all.size()) break;

        const Collision<Real>& next = all[i + 1];
        const Place<Real> there = place_of(next.mass, next.after);
        if (there.wall == place.wall) return say("L1: two collisions in a row with one wall, from", i);
        if (place.wall == Wall::right && now.after.phidot > 0)
            return say("L1: returns after leaving R right", i);
        if (place.wall == Wall::left && now.after.phidot < 0)
            return say("L1: returns after leaving L left", i);
        if (now.after.ydot >= 0 && slope_of(body, now.after) >= 1) return say("L3: a steep ray returns", i);
        if (i + 2 < all.size() && there.wall == Wall::bridge &&
            place_of(all[i + 2].mass, all[i + 2].after).wall == place.wall) {
            return say("L2 (d), L6: R B R at", i);
        }
        const bool comes_and_goes = now.before.phidot * place.side > 0 && now.after.phidot * place.side < 0;
        if (now.mass == Mass::light && comes_and_goes && slope_of(body, now.before) >= -r &&
            slope_of(body, now.after) < r * (1 - 1e-12L)) {
            return say("L6 (b): returns flatter than r at", i);
        }
    }
    if (turning == 0) return "L2 (c): no turning collision";
    if (bridge > 1) return say("L6 (c): the bridge is touched", bridge, "times");
    return "";
}

// The lowest either mass gets between two collisions, by dense sampling; must not be negative.
Real lowest_between(const Dumbbell<Real>& body, const State<Real>& from, Real duration) {
    Real lowest = 1;
    for (int k = 1; k < 64; ++k) {
        State<Real> state = from;
        const Real t = duration * k / 64;
        state.phi += state.phidot * t;
        state.y += state.ydot * t;
        lowest = std::min({lowest, body.height(Mass::light, state), body.height(Mass::heavy, state)});
    }
    return lowest;
}

// Calls use(body, start, contact) for the contacts among so many random starts of all families, of which
// every fiftieth is at a mass ratio of up to `sometimes`.
template <class Use>
void each_contact(std::uint64_t seed, long starts, double greatest, double sometimes, const Use& use) {
    Sampler seeds(1, seed);
    for (long i = 0; i < starts; ++i) {
        const double ratio = random_ratio(seeds, i % 50 == 0 ? sometimes : greatest);
        const Dumbbell<Real> body(ratio);
        const Start start = Sampler(ratio, static_cast<std::uint64_t>(i)).next(all_families[i % 8]);
        const auto real = realize(body, start);
        if (const auto* contact = std::get_if<Contact<Real>>(&real)) use(body, start, *contact);
    }
}

}  // namespace

TEST_CASE("L0: impulse on the touching mass, law (4) of the paper and law (1) agree") {
    Sampler sampler(1, 101);
    for (int i = 0; i < scaled(100'000); ++i) {
        const double ratio = random_ratio(sampler, 1e9);
        const Dumbbell<Real> body(ratio);
        const Mass mass = sampler.coin() ? Mass::light : Mass::heavy;
        const Real scale = sampler.log_uniform(1e-6, 1e6);
        const State<Real> before{sampler.uniform(-7, 7), sampler.uniform(-1, 1) * scale, 0,
                                 sampler.uniform(-1, 1)};
        const State<Real> after = body.bounce(mass, before);
        // psi = phi - pi/2 is rounded; near a peak that turns the wall by sqrt(q) as much.
        const Real tolerance = 1e-18L * (100 + std::sqrt(body.ratio()));
        const bool ok = distance(body, after, body.bounce_by_law4(mass, before)) < tolerance &&
                        distance(body, after, bounce_by_law1(body, mass, before)) < tolerance &&
                        distance(body, before, body.bounce(mass, after)) < tolerance &&
                        close(body.twice_energy(after) / body.twice_energy(before), 1, 1e-15L) &&
                        close(body.climb(mass, after) + body.climb(mass, before), 0, 1e-15L * (1 + scale));
        if (!ok) FAIL(say(ratio, "phi", before.phi, "phidot", before.phidot, "ydot", before.ydot));
    }
    SUCCEED();
}

TEST_CASE("the simulation never lets a mass through the floor, and keeps the energy") {
    each_contact(102, scaled(4'000), 1e4, 1e4, [&](const auto& body, const auto& start, const auto& contact) {
        if (total_collisions(body, start).care.doubtful()) return;
        const auto all = whole_trajectory(body, contact);
        for (std::size_t k = 0; k + 1 < all.size(); ++k) {
            const Real lowest = lowest_between(body, all[k].after, all[k + 1].time - all[k].time);
            const Real energy = body.twice_energy(all[k + 1].after) / body.twice_energy(all[k].after);
            if (lowest < -1e-14L || !close(energy, 1, 1e-14L)) {
                FAIL(say(body.ratio(), describe(start), "flight", k, "lowest", lowest, "energy", energy));
            }
        }
        const Collision<Real>& end = all.back();
        for (const Real duration : {1.0L, 10.0L, 1000.0L}) {
            const Real time = duration / (std::abs(end.after.phidot) + std::abs(end.after.ydot));
            if (lowest_between(body, end.after, time) < -1e-14L)
                FAIL(say(body.ratio(), describe(start), "last flight"));
        }
    });
    SUCCEED();
}

TEST_CASE("running a trajectory backwards from its end repeats it") {
    each_contact(103, scaled(4'000), 1e3, 1e3, [&](const auto& body, const auto& start, const auto& contact) {
        // Errors grow like the reciprocal sine at each contact: keep away from grazing ones.
        if (total_collisions(body, contact).care.least_sine < 1e-3) return;
        const auto there = simulate(body, contact.after, contact.mass);
        if (there.care.near_tangent(1e-6) || there.care.near_corner(1e-3)) return;
        if (there.collisions.empty()) return;
        State<Real> later = there.last;
        later.phi += later.phidot * 0.1L;
        later.y += later.ydot * 0.1L;
        const auto back = simulate(body, reversed(later));
        if (back.collisions.size() < there.collisions.size()) {
            FAIL(say(body.ratio(), describe(start), there.collisions.size(), back.collisions.size()));
        }
    });
    SUCCEED();
}

TEST_CASE("the chart coordinates of a collision stand for the same trajectory") {
    int bridges = 0;
    int lights = 0;
    each_contact(
        104, scaled(6'000), 1e3, 1e3, [&](const auto& body, const auto& /*unused*/, const auto& contact) {
            const auto total = total_collisions(body, contact);
            if (total.care.near_tangent(1e-7) || total.care.near_corner(1e-3)) return;
            bool covered = total.collisions == 1 || total.heavy > 0;
            for (const auto& collision : whole_trajectory(body, contact)) {
                const auto bridge = bridge_state_of(body, collision);
                const auto light = light_state_of(body, collision);
                bridges += bridge.has_value();
                lights += light.has_value();
                covered = covered || light.has_value();
                if (bridge)
                    CHECK(total_collisions(body, contact_of(body, *bridge)).collisions == total.collisions);
                if (light)
                    CHECK(total_collisions(body, contact_of(body, *light)).collisions == total.collisions);
            }
            // L9: without the bridge and with more than one collision there is a state of the light chart.
            if (!covered) FAIL(say("not in the light chart: q", body.ratio()));
        });
    CHECK(bridges > 500);
    CHECK(lights > 500);
}

TEST_CASE("L1, L2, L3, L6: no return, one cell, turning, steep rays leave, one bridge contact") {
    each_contact(105, scaled(30'000), 300, 1e5,
                 [&](const auto& body, const auto& start, const auto& contact) {
                     const auto all = whole_trajectory(body, contact);
                     Real gap = 1;
                     for (const auto& collision : all)
                         gap = std::min(gap, std::sin(place_of(collision.mass, collision.after).e));
                     if (gap < 1e-4L) return;
                     const std::string wrong = broken_rule(body, all);
                     if (!wrong.empty()) FAIL(say("q", body.ratio(), describe(start), wrong));
                 });
    SUCCEED();
}
