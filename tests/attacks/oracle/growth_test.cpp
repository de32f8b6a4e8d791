// L31, L32 and Theorem 4 of proofs/theorem.md and L89 of proofs/growth.md: how the maximum grows.
#include <algorithm>

#include "catch.hpp"
#include "extremal.hpp"
#include "law.hpp"
#include "tangents.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

template <class S>
S wedge_angle(const S& ratio) {  // gamma
    using std::atan;
    using std::sqrt;
    return S(2 * atan(1 / sqrt(ratio)));
}

// V of L89 at the angle theta0: an integral of the change of the height by the valley's width there.
Real in_valley(Real rho, Real c, Real theta0) {
    return 2 * law::integral<Real>(
                   [&](Real theta) {
                       Real lo = 0, hi = pi<Real>() / 2;
                       for (int i = 0; i < 60; ++i) {
                           const Real t = (lo + hi) / 2;
                           (t + std::asin(rho * std::sin(t)) < c / std::cos(theta) ? lo : hi) = t;
                       }
                       const Real steepness = rho * std::cos(lo), height = rho * std::sin(lo);
                       return steepness / (1 + steepness / std::sqrt(1 - height * height));
                   },
                   0, theta0);
}

}  // namespace

TEST_CASE("L31: a collision turns the angle by 2 atan(h / w), and hits stay gamma away from pi/2") {
    Sampler sampler(1, 821);
    int turned = 0;
    for (int i = 0; i < scaled(400); ++i) {
        const Real ratio = sampler.coin() ? random_ratio(sampler, 1e5) : sampler.uniform(2.55, 30);
        const Real r = 1 / ratio;
        const Real h = std::sqrt(r);
        const Real gamma = wedge_angle(ratio);
        for (const bool at_top : {true, false}) {
            const auto all = flights(at_top ? top_ray(r) : corner_ray(r), r);
            for (std::size_t j = 0; j < all.size(); ++j) {
                const Real angle = std::atan(all[j].kappa / h);
                const Real least = (at_top ? 0 : gamma / 2) + static_cast<Real>(j) * gamma;
                if (angle < least - 1e-15L) FAIL(say("q", ratio, "flight", j, angle, least));
                const auto x = hit_place(all[j]);
                if (!x) continue;
                if (ratio >= 2.55L && angle >= pi<Real>() / 2 - gamma)
                    FAIL(say("q", ratio, "flight", j, angle));
                if (j + 1 == all.size()) continue;
                ++turned;
                const Real next = std::atan(all[j + 1].kappa / h);
                if (!close(next - angle, 2 * std::atan(h / std::cos(*x)), 1e-14L))
                    FAIL(say("q", ratio, "flight", j, next - angle));
            }
        }
    }
    CHECK(turned > 5'000);
}

TEST_CASE("L32: (pi + 2 x) cos theta is nearly constant along the first orbit") {
    for (const Real ratio : {1e4L, 1e6L, 1e8L}) {
        const Real r = 1 / ratio;
        const Real h = std::sqrt(r);
        Real worst = 0;
        for (const auto& ray : flights(top_ray(r), r)) {
            const auto x = hit_place(ray);
            if (!x || std::cos(*x) < 0.25L) break;
            const Real product = (pi<Real>() + 2 * *x) * std::cos(std::atan(ray.kappa / h));
            worst = std::max(worst, std::abs(product - pi<Real>()));
        }
        INFO("q " << ratio << " worst " << worst);
        CHECK(worst < 20 * h);
    }
}

TEST_CASE("theorem 4: N* / sqrt q tends to C = 0.8855951...") {
    const Real c = law::tau_by_angle<Real>(0, pi<Real>() / 2);
    CHECK(close(c, 0.8855951L, 1e-7L));
    for (const Real ratio : {1e4L, 1e5L, 1e6L, 1e7L, 1e8L, 1e9L}) {
        const Real root = std::sqrt(ratio);
        const auto [k0, k1] = theorem(ratio);
        INFO("q " << ratio << " k0 " << k0 << " k1 " << k1);
        CHECK(std::abs(2 * static_cast<Real>(k0) - c * root) < 2);
        CHECK(std::abs(2 * static_cast<Real>(k1) - c * root) < 2);
        CHECK(std::abs(static_cast<Real>(2 + k0 + k1) / root - c) < 4 / root);
    }
}

TEST_CASE("L89: for large Q the tangents' counts are near U and V, and their sum is greatest at an end") {
    Sampler sampler(1, 8901);
    for (int i = 0; i < scaled(40); ++i) {
        const Real rho = sampler.uniform(0.02, 0.99), widest = pi<Real>() / 2 + std::asin(rho),
                   theta0 = sampler.uniform(0.05, 1.5), c = widest * std::cos(theta0);
        const Real u = law::tau_by_angle(theta0, c), v = in_valley(rho, c, theta0);
        CAPTURE(rho, theta0, u, v);
        CHECK(u + v < std::max(law::tau_by_angle<Real>(0, widest), pi<Real>() * rho / (1 + rho)));
        const TwoTangents<Real> tangents({static_cast<double>(rho), 1e8});
        const Real e = std::acos(std::tan(theta0) / (rho * 1e4L));
        CHECK(close(2e-4L * static_cast<Real>(tangents.f(e)), u, 1e-3L));
        CHECK(close(2e-4L * static_cast<Real>(tangents.b(e)), v, 0.015L));
    }
}
