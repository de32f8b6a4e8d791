// proofs/theorem.md, Theorem 5: the share of the trajectories with as many collisions as any, at a ratio and
// as the ratio falls to the step.
#include <cmath>
#include <random>

#include "catch.hpp"
#include "extremal.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

Real uniform_real(std::mt19937_64& engine, Real lo, Real hi) {
    return lo + (hi - lo) * std::uniform_real_distribution<double>(0, 1)(engine);
}

struct Estimate {
    Real value, error;  ///< of a mean, and its standard deviation
};

/// Theorem 5 (a), by random contacts with e in [from, to] and eta up to `most`, drawn with a weight that eta
/// has: each is simulated forward and backward.
Estimate share_of_contacts(Real q, std::size_t n, Real from, Real to, Real most, long samples,
                           std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const Dumbbell<Real> body(q);
    const Real r = 1 / q;
    Real sum = 0, squares = 0;
    for (long i = 0; i < samples; ++i) {
        const Real e = uniform_real(engine, from, to), eta = most * std::sqrt(uniform_real(engine, 0, 1));
        const auto total = total_collisions(body, contact_of(body, BridgeState<Real>{e, eta}));
        const Real rise = std::cos(e) + eta;
        const Real value = total.collisions == n ? std::pow(1 + r * rise * rise, Real(-1.5)) : 0;
        sum += value;
        squares += value * value;
    }
    const Real scale = r / pi<Real>() * (to - from) * most * most / 2, mean = sum / samples;
    return {scale * mean, scale * std::sqrt((squares / samples - mean * mean) / samples)};
}

/// Delta of Theorem 5 (b).
Real reach(std::size_t n, Real r) {
    Real least = 0, most = 1;
    for (int i = 0; i < 60; ++i) {
        const Real t = (least + most) / 2;
        const Ray<Real> ray = n % 2 == 1 ? Ray<Real>{r * (1 + pi<Real>() * t / 2), r * t}
                                         : Ray<Real>{pi<Real>() * r * (1 + t), r * (1 + t)};
        (ray_count(ray, r) >= orbit_count(n) ? least : most) = t;
    }
    return least;
}

Real predicted(std::size_t n, Real r, Real delta) {
    return n % 2 == 1 ? r * delta * delta * delta / (6 * pi<Real>())
                      : 4 * std::sqrt(Real(2)) / (15 * pi<Real>()) * r * std::pow(1 + r, Real(-1.5)) *
                            std::pow(delta, Real(2.5));
}

}  // namespace

TEST_CASE("theorem 5: the contacts with the bridge give the share of incoming trajectories") {
    std::mt19937_64 engine(505);
    for (const auto& [q, n] : {std::pair(2.0L, 3), {4.5L, 3}, {10.0L, 4}}) {
        const Dumbbell<Real> body(q);
        const long samples = scaled(20'000);
        int found = 0;
        for (int i = 0; i < samples; ++i) {
            const Real phi = uniform_real(engine, 0, 2 * pi<Real>()), s = uniform_real(engine, -1, 1);
            const auto run = simulate(body, State<Real>{phi, s * std::sqrt(body.ratio()), 2 * body.beta2(),
                                                        -std::sqrt(1 - s * s) * body.beta2()});
            found += run.collisions.size() == static_cast<std::size_t>(n) ? 1 : 0;
        }
        const Real seen = static_cast<Real>(found) / samples;
        const Estimate share =
            share_of_contacts(q, static_cast<std::size_t>(n), 0, pi<Real>() / 2, q, samples, 506);
        const Real error = 5 * (share.error + std::sqrt(seen / samples));
        INFO(say("q", q, "N", n, "simulated", seen, "by contacts", share.value, "+-", share.error));
        CHECK(found > samples / 1'200);
        CHECK(std::abs(share.value - seen) < error);
    }
}

TEST_CASE("theorem 5: just above a step the record's share falls like the cube, or the power 5/2") {
    for (const std::size_t n : {3U, 4U, 5U, 6U, 9U, 10U}) {
        const Real step = n == 3 ? 1 : critical_ratio(n).above;
        Real before = 0;
        for (const Real above : {1e-2L, 1e-3L, 1e-4L}) {
            const Real q = step * (1 + above), r = 1 / q, delta = reach(n, r);
            // All contacts with so many collisions, by the inequalities that are proved to hold there.
            const Estimate share = n % 2 == 1 ? share_of_contacts(q, n, std::acos(delta), pi<Real>() / 2,
                                                                  delta, scaled(1'500), n)
                                              : share_of_contacts(q, n, 0, 1.05L * std::sqrt(2 * delta),
                                                                  1.5L * delta, scaled(1'500), n);
            const Real order = n % 2 == 1 ? 3 * delta : 3 * std::sqrt(delta);
            INFO(say("N", n, "q", q, "Delta", delta, "share", share.value, "+-", share.error, "predicted",
                     predicted(n, r, delta)));
            CHECK(std::abs(share.value / predicted(n, r, delta) - 1) < order + 6 * share.error / share.value);
            if (above == 1e-4L) {
                const Real exponent = std::log10(before / share.value);
                CHECK(std::abs(exponent - (n % 2 == 1 ? 3 : 2.5L)) < 0.15L);
            }
            before = share.value;
        }
    }
}
