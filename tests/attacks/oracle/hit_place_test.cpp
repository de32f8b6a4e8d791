// proofs/lemmas.md, L12: bounds of where a ray hits a light wall.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

constexpr Real slack = 1e-16L;  // rounding of a few operations on values of order 1

struct Case {
    double c;
    double kappa;
    double r;
};

std::string text(const Case& a) { return say("c", a.c, "kappa", a.kappa, "r", a.r); }

// c >= 0, -r <= kappa < 1, often at an edge, and often such that the count is large.
Case random_case(Sampler& sampler) {
    const double r = 1 / random_ratio(sampler, 1e4);
    const double kappa = sampler.coin() ? biased(sampler, -r, 2 * r) : biased(sampler, -r, 0.999);
    double c = sampler.coin() ? biased(sampler, 0, 3 * r) : biased(sampler, 0, 1);
    if (sampler.uniform(0, 1) < 0.2 && kappa < 1) {
        // Next to a tangency with the light wall.
        const double edge = static_cast<double>(greatest_excess(Ray<Real>{0, kappa}));
        c = std::max(0.0, edge * (1 - sampler.log_uniform(1e-12, 0.1)));
    }
    return {c, std::min(kappa, 0.999), r};
}

}  // namespace

TEST_CASE("L12: tangent bound, upper bound, strict miss, and cosine and sine near a point") {
    Sampler sampler(1, 307);
    int misses = 0;
    for (int i = 0; i < scaled(200'000); ++i) {
        const Case at = random_case(sampler);
        const Real c = at.c;
        const Real kappa = at.kappa;
        const Real half_turn = pi<Real>() / 2;
        const Real z = biased(sampler, 0, 1.5707963267948966);
        const Real d = sampler.log_uniform(1e-6, 1);
        const auto g = [c, kappa](Real x) { return std::sin(x) - kappa * x - c; };
        const auto root = hit_place(Ray<Real>{c, kappa});
        const Real p = std::cos(z) - kappa;
        if (p > 1e-9L && root && *root < z - g(z) / p - 1e-9L) FAIL("(a) " << text(at) << say("z", z));
        if (p > 0 && z + d <= half_turn && std::abs(g(z)) / p + d * d / (2 * p) <= d) {
            if (g(z + d) < -slack) FAIL("(b) sign " << text(at) << say("z", z, "d", d));
            if (root && *root > z + d + 1e-9L) FAIL("(b) root " << text(at) << say("z", z, "d", d));
        }
        if (c - std::sin(z) + z * std::cos(z) > 0 &&
            c + kappa * half_turn - std::sin(z) - (half_turn - z) * std::cos(z) > 0) {
            ++misses;
            if (greatest_excess(Ray<Real>{c, kappa}) > slack) FAIL("(c) " << text(at) << say("z", z));
        }
        if (std::abs(std::cos(z + d) - (std::cos(z) - d * std::sin(z))) > d * d / 2 + slack ||
            std::abs(std::sin(z + d) - (std::sin(z) + d * std::cos(z))) > d * d / 2 + slack) {
            FAIL("(d) " << say("z", z, "d", d));
        }
    }
    CHECK(misses > 1'000);
}
