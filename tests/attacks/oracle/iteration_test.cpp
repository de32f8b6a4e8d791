// Lemmas L4, L6, L8, L9: the formulas of the charts against the physical simulation, collision by collision.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

struct Agreement {
    int collisions = 0;
    Real worst = 0;
};

// Follows the iteration of L4 along the light collisions of a run. Empty if they agree.
template <class S>
std::string compare(const Dumbbell<S>& body, const Run<S>& run, std::optional<Ray<S>> ray, double tolerance,
                    Agreement& seen) {
    const S r = 1 / body.ratio();
    for (std::size_t i = 0;; ++i) {
        const std::optional<Step<S>> taken = ray ? step(*ray, r) : std::nullopt;
        const bool more = i < run.collisions.size();
        if (!taken || !more) {
            return taken.has_value() == more ? "" : say("number of collisions differs from", i, "on");
        }
        const Collision<S>& collision = run.collisions[i];
        if (collision.mass != Mass::light) return say("the bridge is met at", i);
        const Real place = static_cast<Real>(place_of(collision.mass, collision.after).e - taken->x);
        Real slope = 0;
        if (taken->next) slope = static_cast<Real>(slope_of(body, collision.after) / taken->next->kappa - 1);
        const Real error = std::max(std::abs(place), std::abs(slope));
        seen.worst = std::max(seen.worst, error);
        ++seen.collisions;
        if (!(error < tolerance)) return say("collision", i, "differs: place", place, "slope", slope);
        ray = taken->next;
    }
}

template <class S>
Run<S> forward(const Dumbbell<S>& body, const Contact<S>& contact) {
    return simulate(body, contact.after, contact.mass);
}

template <class S>
Run<S> backward(const Dumbbell<S>& body, const Contact<S>& contact) {
    return simulate(body, reversed(body.bounce(contact.mass, contact.after)), contact.mass);
}

// Everything that L8 says about one bridge contact with X in play or not: the two rays and the total.
template <class S>
std::string bridge_disagreement(const Dumbbell<S>& body, const BridgeState<S>& state, double tolerance,
                                Agreement& seen) {
    const S r = 1 / body.ratio();
    const Contact<S> contact = contact_of(body, state);
    const Run<S> x = forward(body, contact);
    const Run<S> sigma_x = backward(body, contact);
    std::string wrong = compare(body, x, std::optional(bridge_ray(state, r)), tolerance, seen);
    if (!wrong.empty()) return "X: " + wrong;
    wrong = compare(body, sigma_x, std::optional(bridge_ray_reversed(state, r)), tolerance, seen);
    return wrong.empty() ? "" : "sigma X: " + wrong;
}

// theory.md L4: a ray from R with 0 <= kappa < 1 clears the bridge.
bool clears_bridge(Real e, Real kappa, Real r) {
    const Real big_a =
        std::sin(e) + kappa * (3 * pi<Real>() / 2 + e);  // cos u0 + kappa (2 pi - u0), u0 = pi/2 - e
    return kappa >= r ||
           big_a - kappa * pi<Real>() >= std::sqrt(r * r - kappa * kappa) + kappa * std::asin(kappa / r);
}

}  // namespace

TEST_CASE("L4, L6, L8: both rays of a bridge contact follow the iteration and never meet the bridge again") {
    Sampler seeds(1, 201);
    const long contacts = scaled(10'000);
    Agreement seen;
    for (int i = 0; i < contacts; ++i) {
        const double ratio = random_ratio(seeds, i % 100 == 0 ? 1e6 : 1e3);
        Sampler sampler(ratio, static_cast<std::uint64_t>(i));
        const Dumbbell<Real> body(ratio);
        const Family family = i % 3 == 0   ? Family::top_orbit
                              : i % 3 == 1 ? Family::corner_orbit
                                           : Family::low_slopes;
        const Start start = sampler.next(family);
        const auto* seed = std::get_if<BridgeState<double>>(&start);
        if (seed == nullptr) continue;
        const BridgeState<Real> state{seed->e, seed->eta};
        const auto care = total_collisions(body, contact_of(body, state)).care;
        if (care.near_tangent(1e-9) || care.near_corner(1e-4)) continue;
        const std::string wrong = bridge_disagreement(body, state, 1e-7, seen);
        if (!wrong.empty()) FAIL(say("q", ratio, describe(start), wrong));
    }
    INFO(seen.collisions << " collisions, worst difference " << seen.worst);
    CHECK(seen.collisions > contacts * 6 / 5);
}

TEST_CASE("L4, L8: the same with 80 digits next to corners, grazing contacts and peaks") {
    Sampler seeds(1, 202);
    Agreement seen;
    for (int i = 0; i < scaled(300); ++i) {
        const double ratio = random_ratio(seeds, 300);
        const Dumbbell<Digits80> body{Digits80(ratio)};
        const double e =
            i % 2 == 0 ? seeds.log_uniform(1e-12, 1e-3) : 1.5707963267948966 - seeds.log_uniform(1e-12, 1);
        const double eta = seeds.log_uniform(1e-24, 1);
        const std::string wrong =
            bridge_disagreement(body, BridgeState<Digits80>{Digits80(e), Digits80(eta)}, 1e-7, seen);
        if (!wrong.empty()) FAIL(say("q", ratio, "e", e, "eta", eta, wrong));
    }
    INFO(seen.collisions << " collisions, worst difference " << seen.worst);
    CHECK(seen.collisions > 100);
}

TEST_CASE(
    "L4, L9: the rays of a light contact follow the iteration until the bridge, which the criterion finds") {
    Sampler seeds(1, 203);
    Agreement seen;
    int met = 0;
    for (int i = 0; i < scaled(25'000); ++i) {
        const double ratio = random_ratio(seeds, i % 100 == 0 ? 1e6 : 1e3);
        const Real r = 1 / static_cast<Real>(ratio);
        const Dumbbell<Real> body(ratio);
        const Real e = seeds.coin() ? seeds.uniform(1e-3, 1.57) : seeds.log_uniform(1e-3, 1.57);
        const Real kappa = seeds.log_uniform(1e-7, 1);
        const LightState<Real> state{e, kappa / r};
        const Contact<Real> contact = contact_of(body, state);
        const Ray<Real> ray = light_ray(state, r);
        for (const bool forwards : {true, false}) {
            const std::optional<Ray<Real>> way = forwards ? std::optional(ray) : light_ray_reversed(state, r);
            const Run<Real> run = forwards ? forward(body, contact) : backward(body, contact);
            if (run.care.near_tangent(1e-6) || run.care.near_corner(1e-3)) continue;
            std::string wrong;
            if (!way) {
                if (!run.collisions.empty()) wrong = "D <= 0, but it returns";
            } else if (way->kappa >= 0) {
                const bool bridge_first = !run.collisions.empty() && run.collisions[0].mass == Mass::heavy;
                met += bridge_first;
                if (bridge_first == clears_bridge(e, way->kappa, r)) wrong = "the bridge criterion is wrong";
                if (!bridge_first) wrong = compare(body, run, way, 1e-7, seen);
            }
            if (!wrong.empty())
                FAIL(say("q", ratio, "e", e, "kappa", kappa, forwards ? "X:" : "sigma X:", wrong));
        }
    }
    INFO(seen.collisions << " collisions, worst difference " << seen.worst);
    CHECK(seen.collisions > 10'000);
    CHECK(met > 500);
}
