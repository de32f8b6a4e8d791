// proofs/lemmas.md, L40: trajectories into a corner, where both masses stand on the floor at once, against
// the simulation.
#include <algorithm>

#include "catch.hpp"
#include "extremal.hpp"
#include "simulate.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

// Away from the corner, a little after it: in free flight, `shift` above the line that comes out of the
// corner (light mass to the right). Going left with the given slope, or right.
State<Digits80> out_of_corner(const Dumbbell<Digits80>& body, double slope, bool left, double shift) {
    const Digits80 later = 1e-6;
    const Digits80 phidot = left ? -1 : 1;
    const Digits80 ydot = body.beta2() * Digits80(slope);
    return {pi<Digits80>() + phidot * later, phidot, Digits80(ydot * later + body.beta2() * Digits80(shift)),
            ydot};
}

// Slopes from the bridge's tangent at the corner on, where the longest of these trajectories are.
double steepness(Sampler& sampler, double ratio) {
    if (sampler.coin()) return 1 / ratio * (1 + sampler.log_uniform(1e-9, 1));
    return 1 / ratio + sampler.uniform(0, sampler.coin() ? 0.3 : 2);
}

double ratio_with_a_corner_orbit(Sampler& sampler) {
    if (sampler.coin()) return random_ratio(sampler, 300);
    const auto n = 2 * static_cast<std::size_t>(sampler.uniform(2, 9));  // where 2 + 2 k1 begins to be N*
    return static_cast<double>(critical_ratio(n).above) * (1 + sampler.log_uniform(1e-6, 1e-2));
}

// The collisions on one side of a corner, by a random velocity there: after it, or, reversed, before it.
std::size_t one_side(Sampler& sampler, double ratio, std::size_t k1) {
    const Dumbbell<Digits80> body{Digits80(ratio)};
    const bool left = sampler.uniform(0, 1) < 0.9;
    const double slope = left ? steepness(sampler, ratio) : 1 + sampler.log_uniform(1e-9, 10);
    const auto run = simulate(body, out_of_corner(body, slope, left, 0));
    const std::size_t count = run.collisions.size();
    const auto told = say("q", ratio, "slope", slope, left ? "left" : "right", count, k1);
    if (count > k1) FAIL(told);
    if (!left && count > 0) FAIL(told);
    if (std::any_of(run.collisions.begin(), run.collisions.end(),
                    [](const auto& c) { return c.mass == Mass::heavy; }))
        FAIL(told);
    if (run.care.least_gap < 1e-12) FAIL(told + "meets another corner");
    return count;
}

}  // namespace

TEST_CASE("L40: a corner taken as two, at most N* before and after it together, whatever the velocities") {
    Sampler sampler(1, 4001);
    std::size_t most = 0;
    const long orbits = scaled(400);
    int tight = 0;
    for (int i = 0; i < orbits; ++i) {
        const double ratio = ratio_with_a_corner_orbit(sampler);
        const auto stated = theorem(Digits80(ratio));
        const std::size_t before = one_side(sampler, ratio, stated.k1);
        const std::size_t after = one_side(sampler, ratio, stated.k1);
        if (2 + before + after > stated.maximum()) FAIL(say("q", ratio, before, after, stated.maximum()));
        most = std::max({most, before, after});
        tight += 2 + before + after == stated.maximum() && before > 0 && after > 0 ? 1 : 0;
    }
    CHECK(most > 5);
    CHECK(tight > orbits / 15);
}

TEST_CASE(
    "L40: regular trajectories that pass a corner nearly have the same collisions twice, and two there") {
    Sampler sampler(1, 4002);
    const long orbits = scaled(70);
    int passed = 0;
    for (int i = 0; i < orbits; ++i) {
        const double ratio = ratio_with_a_corner_orbit(sampler);
        const Dumbbell<Digits80> body{Digits80(ratio)};
        const std::size_t maximum = theorem(Digits80(ratio)).maximum();
        const double slope = 1 / ratio * (1 + sampler.log_uniform(1e-3, 1)) + sampler.uniform(0, 0.05);
        const auto exact = simulate(body, out_of_corner(body, slope, true, 0));
        for (const double shift : {1e-40, -1e-40}) {
            const State<Digits80> flight = out_of_corner(body, slope, true, shift);
            const std::size_t total = total_collisions(body, flight).collisions;
            const auto told = say("q", ratio, "slope", slope, "shift", shift, exact.collisions.size(), total);
            if (total > maximum || total < 2 + 2 * exact.collisions.size()) FAIL(told);
            // The two contacts near the corner, one of each mass, reverse the velocity.
            const auto back = simulate(body, reversed(flight)).collisions;
            if (back.size() < 2 || back[0].mass == back[1].mass) FAIL(told);
            const State<Digits80>& after = back[1].after;
            if (!close(static_cast<Real>(after.phidot), static_cast<Real>(flight.phidot), 1e-15L) ||
                !close(static_cast<Real>(after.ydot), static_cast<Real>(flight.ydot), 1e-15L))
                FAIL(told);
            ++passed;
        }
    }
    CHECK(passed >= 2 * orbits);
}
