// proofs/theorem.md, L31, L32 and Theorem 4: how the maximum grows.
#include <algorithm>

#include "catch.hpp"
#include "extremal.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

template <class S>
S wedge_angle(const S& ratio) {  // gamma
    using std::atan;
    using std::sqrt;
    return S(2 * atan(1 / sqrt(ratio)));
}

// integral of sin((pi/2) / cos theta) from 0 to pi/3, by Simpson's rule.
Real size_constant() {
    const int parts = 2'000;
    const Real width = pi<Real>() / 3 / parts;
    const auto f = [](int i, Real h) {
        return std::sin(pi<Real>() / 2 / std::cos(static_cast<Real>(i) * h));
    };
    Real sum = f(0, width) + f(parts, width);
    for (int i = 1; i < parts; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(i, width);
    return sum * width / 3;
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
    const Real c = size_constant();
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
