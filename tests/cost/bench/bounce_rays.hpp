#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "flight/ray.hpp"
#include "rooms/number/random.hpp"

/// What every measurement of a bounce follows: the same rays, and the bounce in plain double that all others
/// are compared with. A bounce is a flight to a light wall and the reflection there; the last flight of a
/// ray, which finds no wall, counts as one.
namespace dumbbell_bench {

inline constexpr long cap = 1'000'000;

/// Outgoing rays of contacts with the bridge at ratios near q (L8): what a cover and a witness follow.
inline std::vector<dumbbell::flight::Ray<double>> bridge_rays(double q, std::size_t n) {
    dumbbell_test::Random random(1);
    std::vector<dumbbell::flight::Ray<double>> rays;
    while (rays.size() < n) {
        const double r = 1 / (q * random.uniform(0.5, 1));
        const double e = random.uniform(0, std::numbers::pi / 2);
        const double eta = random.coin() ? random.uniform(0, 10) : random.scaled(1e-3, 0.3) / r;
        const double kappa = r * (std::cos(e) + eta);
        if (kappa < 1) {
            rays.push_back({r * std::sin(e) + kappa * (std::numbers::pi - e), kappa, r});
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

/// The best that a careful programmer would write with libm: the contact is guessed from the ray's last
/// three, the first ones from the ray alone; a step of fourth order, with one call for sine and cosine; and
/// close to the contact Taylor's formula instead of another call.
inline long warm_count(const dumbbell::flight::Ray<double>& ray) {
    double c = ray.c;
    double kappa = ray.kappa;
    double before[2] = {0, 0};
    double x = 0;
    for (long count = 0;; ++count) {
        if (kappa >= 1) {
            return count;
        }
        double z = 0;
        if (count < 3) {
            const double inverse = 1 / (1 - kappa);
            const double t = c * inverse;
            const double s = std::min(t * t * inverse * (1.0 / 6), 0.15);
            z = t * (1 + s + s * s * (3 + s * 12));
        } else {
            z = 3 * (x - before[1]) + before[0];
        }
        before[0] = before[1];
        before[1] = x;
        double sine = 0;
        double cosine = 0;
        double d = 0;
        for (int step = 0;; ++step) {
            if (!(z <= std::numbers::pi / 2) || step == 60) {
                return count;
            }
            sine = std::sin(z);
            cosine = std::cos(z);
            const double slope = cosine - kappa;
            if (!(slope > 0)) {
                return count;
            }
            const double inverse = 1 / slope;
            const double newton = (c + kappa * z - sine) * inverse;
            const double bend = 0.5 * sine * inverse;
            d = newton * (1 + bend * newton * (1 + 2 * bend * newton)) +
                cosine * inverse * (1.0 / 6) * newton * newton * newton;
            if (std::abs(d) <= 0x1p-13) {
                break;
            }
            z += std::abs(bend * newton) < 0.25 ? d : newton;
        }
        x = z + d;
        if (x > std::numbers::pi / 2) {
            return count;
        }
        const double half = 0.5 * d * d;
        const double odd = d - half * d * (1.0 / 3);
        const double even = half - half * half * (1.0 / 6);
        const double there = sine + (cosine * odd - sine * even);
        const double w = cosine - (sine * odd + cosine * even);
        const double denominator = w * w - 2 * kappa * w - ray.r;
        if (denominator <= 0) {
            return count + 1;
        }
        kappa = (kappa * w * w + ray.r * (2 * w - kappa)) / denominator;
        c = there + kappa * (x + std::numbers::pi);
    }
}

}  // namespace dumbbell_bench
