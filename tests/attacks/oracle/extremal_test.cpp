// L20 of proofs/lemmas.md, L21-L25 and Theorem 1 of proofs/theorem.md: which trajectories are longest,
// against the simulation.
#include "extremal.hpp"

#include <algorithm>

#include "catch.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

const Real half_turn = pi<Real>() / 2;
const Digits80 half_turn_80 = pi<Digits80>() / 2;

// Ratios where something is tight: random, close to 1, and next to critical ratios.
double hard_ratio(Sampler& sampler, double greatest) {
    const double pick = sampler.uniform(0, 1);
    if (pick < 0.6) return random_ratio(sampler, greatest);
    const auto n = static_cast<std::size_t>(sampler.uniform(4, 16));
    const double gap = sampler.log_uniform(1e-12, 1e-3);
    const auto critical = static_cast<double>(critical_ratio(n).above);
    return critical * (sampler.coin() ? 1 + gap : 1 - gap);
}

}  // namespace

TEST_CASE("L20: a count survives a small enough change of ray and ratio") {
    Sampler sampler(1, 801);
    const Digits80 tiny = 1e-60;
    std::size_t most = 0;
    for (int i = 0; i < trials(3'000); ++i) {
        const double ratio = hard_ratio(sampler, 300);
        const Digits80 r = 1 / Digits80(ratio);
        Ray<Digits80> ray{0, -r};
        const double pick = sampler.uniform(0, 1);
        if (pick < 0.2) {
            ray = top_ray(r);
        } else if (pick < 0.4) {
            ray = corner_ray(r);
        } else if (pick < 0.8) {
            ray = {Digits80(r * biased(sampler, 0, 4)), Digits80(r * biased(sampler, -1, 2))};
        }
        const std::size_t before = ray_count(ray, r);
        most = std::max(most, before);
        // Upwards in everything is the direction in which a count can fall (L5 (d)); downwards for r, the
        // rays must stay in the domain.
        const Digits80 r_up = std::min(Digits80(1), Digits80(r + tiny));
        const std::size_t up =
            ray_count(Ray<Digits80>{Digits80(ray.c + tiny), Digits80(ray.kappa + tiny)}, r_up);
        if (up < before) FAIL(say("q", ratio, "c", ray.c, "kappa", ray.kappa, before, up));
    }
    CHECK(most > 5);
}

TEST_CASE("L21: the two tangent counts are monotone along the bridge, k0 and 1 + k1 at its ends") {
    Sampler sampler(1, 802);
    for (int i = 0; i < trials(150); ++i) {
        const double ratio = hard_ratio(sampler, 1e3);
        const Digits80 r = 1 / Digits80(ratio);
        const auto [k0, k1] = theorem(Digits80(ratio));
        if (k1 > k0 || k0 > k1 + 1) FAIL(say("q", ratio, "k0", k0, "k1", k1));
        std::vector<Digits80> places{0, half_turn_80};
        for (int k = 0; k < 8; ++k) {
            const double e = sampler.coin() ? sampler.log_uniform(1e-15, 1.5) : sampler.uniform(0, 1.57);
            places.push_back(sampler.coin() ? Digits80(e) : Digits80(half_turn_80 - e));
        }
        std::sort(places.begin(), places.end());
        std::size_t left = k1;
        std::size_t right = 1 + k1;
        for (const Digits80& e : places) {
            const std::size_t l = count_left(e, r);
            const std::size_t f = count_right(e, r);
            const bool at_corner = e == 0;
            const bool at_top = e == half_turn_80;
            const bool ok = l >= left && f <= right && l <= k0 && f >= k0 &&
                            (!at_corner || (l == k1 && f == 1 + k1)) && (!at_top || (l == k0 && f == k0));
            if (!ok) FAIL(say("q", ratio, "e", e, "left", left, l, "right", right, f, "k", k0, k1));
            left = l;
            right = f;
        }
    }
    SUCCEED();
}

TEST_CASE("L22: a contact with the bridge is worth at most 1 and the two tangent counts at its place") {
    Sampler sampler(1, 803);
    int attained = 0;
    for (int i = 0; i < trials(8'000); ++i) {
        const double ratio = hard_ratio(sampler, 1e4);
        const double e = sampler.coin() ? sampler.uniform(1e-3, 1.57) : sampler.log_uniform(1e-3, 1.57);
        const double eta = sampler.coin() ? sampler.log_uniform(1e-12, 1) : sampler.log_uniform(1e-3, ratio);
        const BridgeState<double> state{e, eta};
        const Dumbbell<Real> body(ratio);
        const Real r = 1 / static_cast<Real>(ratio);
        const auto total = total_collisions(body, contact_of(body, BridgeState<Real>{e, eta}));
        const std::size_t bound =
            1 + count_left(static_cast<Real>(e), r) + count_right(static_cast<Real>(e), r);
        attained += total.collisions == bound;
        if (total.collisions <= bound && total.heavy == 1) continue;
        const Digits80 r_80 = 1 / Digits80(ratio);
        const Dumbbell<Digits80> body_80{Digits80(ratio)};
        const auto again = total_collisions(body_80, contact_of(body_80, BridgeState<Digits80>{e, eta}));
        const std::size_t careful = 1 + count_left(Digits80(e), r_80) + count_right(Digits80(e), r_80);
        if (again.collisions > careful || again.heavy != 1) {
            FAIL(say("q", ratio, describe(state), "has", again.collisions, again.heavy, "bound", careful));
        }
    }
    CHECK(attained > 700);
}

TEST_CASE("L23: of two rays that leave a light wall into the cell, one has slope r or more") {
    Sampler sampler(1, 804);
    int both = 0;
    Real least = 2;
    for (int i = 0; i < trials(200'000); ++i) {
        const Real r = 1 / static_cast<Real>(random_ratio(sampler, 1e9));
        const Real e = sampler.coin() ? biased(sampler, 0, 1.5707963267948966) : sampler.log_uniform(1e-9, 1);
        const Real lambda = biased(sampler, 0, 1);
        const auto back = light_ray_reversed(LightState<Real>{e, lambda}, r);
        if (!back) continue;
        ++both;
        least = std::min(least, std::max(lambda, back->kappa / r));
        if (back->kappa < r * (1 - 1e-15L)) FAIL(say("r", r, "e", e, "lambda", lambda, back->kappa / r));
    }
    CHECK(both > 50'000);
    CHECK(least < 1.000001L);  // and it can be r, at the corner
}

TEST_CASE("L24: without the heavy mass a trajectory falls short of the maximum") {
    Sampler sampler(1, 805);
    int clear = 0;
    int short_by_one = 0;
    for (int i = 0; i < trials(8'000); ++i) {
        const double ratio = hard_ratio(sampler, 1e4);
        const Real r = 1 / static_cast<Real>(ratio);
        const Theorem most = theorem(static_cast<Real>(ratio));
        // The flight along a tangent of the bridge, a little above it, or anything.
        LightState<double> state{sampler.log_uniform(1e-3 * static_cast<double>(r), 1.57),
                                 sampler.log_uniform(1e-3, 3)};
        if (sampler.uniform(0, 1) < 0.7) {
            const Real place = sampler.coin() ? sampler.uniform(1e-3, 1.57) : sampler.log_uniform(1e-3, 1.57);
            const auto ray = bridge_ray_reversed(BridgeState<Real>{place, 0}, r);
            const auto x = hit_place(ray);
            if (!x) continue;
            state = {static_cast<double>(*x * (1 + sampler.log_uniform(1e-9, 1))),
                     static_cast<double>(std::cos(place)) + sampler.log_uniform(1e-12, 0.1)};
        }
        if (state.e >= 1.57) continue;
        const Dumbbell<Real> body(ratio);
        const auto total = total_collisions(body, contact_of(body, LightState<Real>{state.e, state.lambda}));
        if (total.heavy > 0 || total.care.doubtful()) continue;
        ++clear;
        const std::size_t bound = 1 + most.k0 + most.k1;
        short_by_one += total.collisions == bound;
        if (total.collisions > bound) {
            FAIL(say("q", ratio, describe(state), "has", total.collisions, most.k0, most.k1));
        }
        // The finer bounds of the proof.
        const auto back = light_ray_reversed(LightState<Real>{state.e, state.lambda}, r);
        if (!back || back->kappa < 0) continue;
        const Real flat = std::min(static_cast<Real>(state.lambda), back->kappa / r);
        const std::size_t finer = flat >= 1
                                      ? 1 + 2 * most.k1
                                      : 1 + count_left(std::acos(flat), r) + count_right(std::acos(flat), r);
        if (total.collisions > finer) {
            FAIL(say("q", ratio, describe(state), "has", total.collisions, "finer bound", finer));
        }
    }
    CHECK(clear > 1'500);
    CHECK(short_by_one > 100);
}

TEST_CASE("L25: transversal trajectories with 2 + k0 + k1 collisions exist, at hard ratios too") {
    Sampler sampler(1, 806);
    for (int i = 0; i < trials(24); ++i) {
        const double ratio = i == 0 ? 1.0 : hard_ratio(sampler, 200);
        const auto [k0, k1] = theorem(Digits80(ratio));
        const Dumbbell<Digits80> body{Digits80(ratio)};
        bool found = false;
        for (Digits80 small = 1e-2; !found && small > 1e-13; small /= 100) {
            const BridgeState<Digits80> state = k1 == k0
                                                    ? BridgeState<Digits80>{small, Digits80(small * small)}
                                                    : BridgeState<Digits80>{half_turn_80, small};
            const auto total = total_collisions(body, contact_of(body, state));
            if (total.collisions > 2 + k0 + k1) FAIL(say("q", ratio, "small", small, total.collisions));
            found = total.collisions == 2 + k0 + k1 && total.heavy == 1 && total.care.least_sine > 0;
        }
        if (!found) FAIL(say("q", ratio, "k0", k0, "k1", k1, "not attained"));
    }
    SUCCEED();
}
