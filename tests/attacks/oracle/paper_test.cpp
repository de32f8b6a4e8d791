// What proofs/paper.md says of Lemma 4.2 and of Remarks 3.4 and 3.6, against the physical dumbbell.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "catch.hpp"
#include "chart.hpp"
#include "contact_time.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

/// A motion onto the bridge and from there onto a light wall, in the angles of the paper.
struct OverBridge {
    Real fall;  // the angle down from the horizontal
    Real theta, tau, rho, theta_next;
    Real rho_without, theta_without;  // of the motion in the hybrid wedge
};

/// The angle of the velocity with the wall ahead of a motion of this sign, from the straight wedge's line.
Real angle_from_wall(const Dumbbell<Real>& body, const State<Real>& state, Real sign) {
    return std::atan2(std::sqrt(body.ratio()) * state.ydot / body.beta2(), sign * state.phidot) -
           std::atan(std::sqrt(body.ratio()));
}

/// Nothing if the motion does not go on to the next light wall.
std::optional<OverBridge> over_bridge(const Dumbbell<Real>& body, const State<Real>& before, Real e) {
    const Real root = std::sqrt(body.ratio()), gamma = pi<Real>() - 2 * std::atan(root);
    const Real sign = before.phidot > 0 ? 1 : -1;
    const State<Real> after = body.bounce(Mass::heavy, before);
    const auto later = simulate(body, after, Mass::heavy).collisions;
    if (later.empty() || sign * after.phidot <= 0) return std::nullopt;
    const Real x = place_of(later[0].mass, later[0].before).e;
    const Real fall = -before.ydot / body.beta2() / std::abs(before.phidot);
    // Where the flight would come to the light wall without the bridge, and its height at the corner.
    const Real way = sign > 0 ? e : pi<Real>() - e, c = std::sin(e) / body.ratio() - fall * way;
    Real lo = 0, hi = c > 0 ? pi<Real>() / 2 : 0;
    for (int i = 0; i < 70; ++i) {
        const Real middle = (lo + hi) / 2;
        (std::sin(middle) > c - fall * middle ? hi : lo) = middle;
    }
    const auto bend = [&](Real at) { return std::atan(root) - std::atan(root * std::cos(at)); };
    const Real theta = (pi<Real>() + gamma) / 2 + std::atan(root * fall);
    return OverBridge{std::atan(root * fall),
                      theta,
                      std::atan(std::cos(e) / root),
                      bend(x),
                      angle_from_wall(body, later[0].after, sign),
                      bend(lo),
                      theta - gamma - 2 * bend(lo)};
}

}  // namespace

TEST_CASE("Lemma 4.2: behind the top of the bridge (8) has the other sign, and the angles still fall") {
    Sampler sampler(1, 4201);
    int behind = 0, before_top = 0;
    for (int i = 0; i < scaled(5000); ++i) {
        const Dumbbell<Real> body(sampler.uniform(3, 300));
        const BridgeState<Real> at{sampler.uniform(0.01, 1.5), sampler.log_uniform(1e-3, 2)};
        const State<Real> left = contact_of(body, at).after;
        const State<Real> right = body.bounce(Mass::heavy, reversed(left));
        // Contacts at psi > 0: a motion to the right is behind the top.
        for (const State<Real>& from : {reversed(left), reversed(right)}) {
            if (!(from.ydot < 0)) continue;
            const auto seen = over_bridge(body, from, at.e);
            if (!seen) continue;
            const bool is_behind = from.phidot > 0;
            const Real printed = pi<Real>() - seen->theta - 2 * seen->tau - 2 * seen->rho;
            const Real stated = is_behind ? printed + 4 * seen->tau : printed;
            if (!close(seen->theta_next, stated, 1e-12L))
                FAIL(say("q", body.ratio(), "e", at.e, "eta", at.eta, seen->theta_next, stated));
            if (is_behind && !(seen->fall > seen->tau)) FAIL(say("steeper than the tangent", at.e, at.eta));
            if (!(seen->theta_next < seen->theta_without) || !(seen->rho > seen->rho_without - 1e-15L))
                FAIL(say("q", body.ratio(), "e", at.e, "eta", at.eta, "angles", seen->theta_next,
                         seen->theta_without));
            ++(is_behind ? behind : before_top);
        }
    }
    CHECK(behind > 100);
    CHECK(before_top > 100);
}

TEST_CASE("Remark 3.4: between two bounces the light mass travels 2 I/|phidot|, up to O(delta)") {
    Sampler sampler(1, 3401);
    for (const Real delta : {0.03L, 0.01L, 0.003L}) {
        const Dumbbell<Real> body(1 / (delta * delta) - 1);
        Real worst = 0;
        for (int i = 0; i < scaled(150); ++i) {
            const Real u = sampler.uniform(0.3, 1.5), s = sampler.uniform(0, 1);
            const State<Real> before{3 * pi<Real>() / 2 + u, -1, body.beta2() * std::cos(u), -delta * s};
            const State<Real> after = body.bounce(Mass::light, before);
            const auto later = simulate(body, after, Mass::light).collisions;
            if (later.empty() || later[0].mass != Mass::light) continue;
            const Real turned = std::abs(later[0].before.phi - after.phi);
            const Real invariant = std::abs(after.phidot) * (pi<Real>() - std::acos(after.y));
            worst = std::max(worst, std::abs(std::abs(after.phidot) * body.beta2() * turned - 2 * invariant));
        }
        INFO(say("delta", delta, "worst", worst / delta));
        CHECK(worst < 25 * delta);
        CHECK(worst > delta);
    }
}

TEST_CASE("Remark 3.6: the square of the first angle is uniform on (0, 4 pi s delta) as delta falls") {
    for (const Real s : {0.2L, 0.9L})
        for (const Real delta : {1e-3L, 1e-5L}) {
            const Dumbbell<Real> body(1 / (delta * delta) - 1);
            const int phases = 400;
            std::vector<Real> shares;
            for (int i = 0; i < phases; ++i) {
                const Real phi = 2 * pi<Real>() * (static_cast<Real>(i) + 0.5L) / phases;
                // Above the floor's reach.
                const State<Real> from{phi, 1, body.beta2() + 10 * s * delta, -s * delta};
                const auto light = next_contact(body, Mass::light, from, false).time;
                REQUIRE(light);
                CHECK(*light < 20);  // the heavy mass is still far up
                const Real at = phi + *light;
                const Real u = std::atan2(std::abs(std::cos(at)), -std::sin(at));
                shares.push_back(u * u / (4 * pi<Real>() * s * delta));
            }
            std::sort(shares.begin(), shares.end());
            Real worst = 0;
            for (int i = 0; i < phases; ++i)
                worst = std::max(worst, std::abs(shares[static_cast<std::size_t>(i)] -
                                                 (static_cast<Real>(i) + 0.5L) / phases));
            INFO(say("s", s, "delta", delta, "worst", worst));
            CHECK(worst < 2 * std::sqrt(delta) + 1.0L / phases);
        }
}
