#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "flight/batch/query.hpp"
#include "flight/ray.hpp"
#include "rooms/number/random.hpp"

/// What every measurement of a bounce follows: the same rays, and the bounce in plain double that all others
/// are compared with. A bounce is a flight to a light wall and the reflection there; the last flight of a
/// ray, which finds no wall, counts as one.
namespace dumbbell_bench {

inline constexpr long cap = 1'000'000;

/// Outgoing rays of contacts with the bridge at ratios near q (L8): what a cover and a witness follow.
inline std::vector<dumbbell::flight::batch::Query> bridge_rays(double q, std::size_t n) {
    dumbbell_test::Random random(1);
    std::vector<dumbbell::flight::batch::Query> rays;
    while (rays.size() < n) {
        const double r = 1 / (q * random.uniform(0.5, 1));
        const double e = random.uniform(0, std::numbers::pi / 2);
        const double eta = random.coin() ? random.uniform(0, 10) : random.scaled(1e-3, 0.3) / r;
        const double kappa = r * (std::cos(e) + eta);
        if (kappa < 1) {
            rays.push_back({{r * std::sin(e) + kappa * (std::numbers::pi - e), kappa, r}, cap});
        }
    }
    return rays;
}

/// What nobody would prove anything with: Newton's iteration and the reflection as in src/model, libm's sine
/// and cosine.
inline long plain_count(const dumbbell::flight::Ray<double>& ray) {
    double c = ray.c;
    double kappa = ray.kappa;
    for (long count = 0;; ++count) {
        if (kappa >= 1) {
            return count;
        }
        double x = c / (1 - kappa);
        double sine = 0;
        double cosine = 0;
        for (int step = 0;; ++step) {
            if (!(x <= std::numbers::pi / 2) || step == 60) {
                return count;
            }
            sine = std::sin(x);
            cosine = std::cos(x);
            if (!(cosine > kappa)) {
                return count;
            }
            const double next = x - (sine - kappa * x - c) / (cosine - kappa);
            const bool done = !(std::abs(next - x) > 0x1p-50 * x);
            x = next;
            if (done) {
                break;
            }
        }
        const double denominator = cosine * cosine - 2 * kappa * cosine - ray.r;
        if (denominator <= 0) {
            return count + 1;
        }
        kappa = (kappa * cosine * cosine + ray.r * (2 * cosine - kappa)) / denominator;
        c = sine + kappa * (x + std::numbers::pi);
    }
}

}  // namespace dumbbell_bench
