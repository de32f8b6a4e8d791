// Remarks of the theory note that are not in the lemma set but that a search or a reader may lean on.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

struct Later {
    std::size_t collisions;
    bool meets_bridge;  // as the first thing
    bool doubtful;
};

// Collisions left for a ray that leaves R at corner distance e to the left.
Later later(double ratio, Real e, Real kappa) {
    const Dumbbell<Real> body(ratio);
    const auto contact = contact_of(body, LightState<Real>{e, kappa * body.ratio()});
    const auto run = simulate(body, contact.after, contact.mass);
    const bool bridge = !run.collisions.empty() && run.collisions[0].mass == Mass::heavy;
    return {run.collisions.size(), bridge, run.care.near_tangent(1e-12) || run.care.near_corner()};
}

}  // namespace

TEST_CASE("L5 (theory): lower and flatter rays collide at least as often unless both meet the bridge") {
    Sampler sampler(1, 701);
    int clear = 0;
    int one_meets = 0;
    int lost = 0;
    for (int i = 0; i < trials(60'000); ++i) {
        const double ratio = random_ratio(sampler, 2e3);
        const double r = 1 / ratio;
        const double e_high = sampler.coin() ? biased(sampler, 1e-3 * r, 3 * r) : biased(sampler, 1e-3, 1.57);
        const double kappa_high = sampler.coin() ? biased(sampler, 0, 3 * r) : biased(sampler, 0, 0.3);
        const double e_low = sampler.uniform(0, 1) < 0.3 ? e_high : e_high * sampler.uniform(0.01, 1);
        const double kappa_low =
            sampler.uniform(0, 1) < 0.3 ? kappa_high : kappa_high * sampler.uniform(0, 1);
        const Later high = later(ratio, std::min(e_high, 1.57), kappa_high);
        const Later low = later(ratio, std::min(e_low, 1.57), kappa_low);
        if (high.doubtful || low.doubtful) continue;
        const bool fewer = low.collisions < high.collisions;
        if (high.meets_bridge) {
            lost += fewer;
            continue;
        }
        ++(low.meets_bridge ? one_meets : clear);
        if (fewer)
            FAIL(say("q", ratio, "e", e_high, e_low, "kappa", kappa_high, kappa_low, high.collisions,
                     low.collisions));
    }
    CHECK(clear > 10'000);
    CHECK(one_meets > 1'000);
    CHECK(lost > 10);  // and it is really lost if both do
}

TEST_CASE(
    "L5 (theory): at q = 1000 two rays that meet the bridge lose the order, 15 against 14 collisions left") {
    const Real r = 1e-3L;
    CHECK(later(1000, std::asin(0.9L * r), 0).collisions == 15);
    CHECK(later(1000, std::asin(0.5L * r), 0).collisions == 14);
}

TEST_CASE("L6 (theory): an ascending reflection that stays in the cell adds at least 2 r to the slope") {
    Sampler sampler(1, 702);
    for (int i = 0; i < trials(100'000); ++i) {
        const Real r = 1 / static_cast<Real>(random_ratio(sampler, 1e9));
        const Real kappa = sampler.coin() ? biased(sampler, 0, 1) : sampler.log_uniform(1e-9, 1);
        const Real x = biased(sampler, 0, 1.5707963267948966);
        const auto next = slope_after(kappa, x, r);
        if (next && *next < (kappa + 2 * r) * (1 - 1e-15L)) FAIL(say("r", r, "kappa", kappa, "x", x));
    }
    SUCCEED();
}

TEST_CASE("theory 4: a ray from a light wall that hits has slope below 1 / sqrt(1 + pi^2)") {
    Sampler sampler(1, 703);
    const Real limit = 1 / std::sqrt(1 + pi<Real>() * pi<Real>());
    Real steepest = 0;
    for (int i = 0; i < trials(100'000); ++i) {
        const Real e = sampler.coin() ? biased(sampler, 0, 1.57) : sampler.log_uniform(1e-9, 1);
        const Real kappa = biased(sampler, 0, 1);
        if (hit_place(Ray<Real>{std::sin(e) + kappa * (pi<Real>() + e), kappa}))
            steepest = std::max(steepest, kappa);
    }
    INFO("steepest " << steepest << " limit " << limit);
    CHECK(steepest < limit);
    CHECK(steepest > 0.5L * limit);
}

TEST_CASE("theory 4: at a turning contact on a light wall with both rays in play one slope is at least r") {
    Sampler sampler(1, 704);
    int both = 0;
    for (int i = 0; i < trials(200'000); ++i) {
        const Real r = 1 / static_cast<Real>(random_ratio(sampler));
        const Real e = biased(sampler, 0, 1.5707963267948966);
        const Real kappa =
            sampler.coin() ? biased(sampler, 0, static_cast<double>(r)) : sampler.uniform(0, 1);
        const auto back = light_ray_reversed(LightState<Real>{e, kappa / r}, r);
        if (!back || back->kappa < 0 || back->kappa >= 1) continue;
        ++both;
        if (std::max(kappa, back->kappa) < r * (1 - 1e-15L))
            FAIL(say("r", r, "e", e, "kappa", kappa, back->kappa));
    }
    CHECK(both > 10'000);
}
