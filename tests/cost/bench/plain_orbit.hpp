#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rooms/flight/hard_orbits.hpp"

namespace dumbbell_bench {

/// What nobody would prove anything with.
struct PlainOrbit {
    long collisions;
    double x;  ///< of the last departure
};

/// The unit of every other cost, the best that a careful programmer would write with libm: the contact is
/// guessed from the ray's last three, the first ones from the ray alone; a step of fourth order, with one
/// call for sine and cosine; and close to the contact Taylor's formula instead of another call.
inline PlainOrbit plain_orbit(const dumbbell_test::HardOrbit& orbit) {
    double x = orbit.x;
    double kappa = orbit.kappa;
    double c = std::sin(x) + kappa * (x + std::numbers::pi);
    double before[2] = {0, 0};
    for (long count = 0;; ++count) {
        if (kappa >= 1) {
            return {count, x};
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
        double sine = 0;
        double cosine = 0;
        double d = 0;
        for (int step = 0;; ++step) {
            if (!(z <= std::numbers::pi / 2) || step == 60) {
                return {count, x};
            }
            sine = std::sin(z);
            cosine = std::cos(z);
            const double slope = cosine - kappa;
            if (!(slope > 0)) {
                return {count, x};
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
        if (z + d > std::numbers::pi / 2) {
            return {count, x};
        }
        const double half = 0.5 * d * d;
        const double odd = d - half * d * (1.0 / 3);
        const double even = half - half * half * (1.0 / 6);
        const double there = sine + (cosine * odd - sine * even);
        const double w = cosine - (sine * odd + cosine * even);
        const double denominator = w * w - 2 * kappa * w - orbit.r;
        if (denominator <= 0) {
            return {count + 1, x};
        }
        before[0] = before[1];
        before[1] = x;
        x = z + d;
        kappa = (kappa * w * w + orbit.r * (2 * w - kappa)) / denominator;
        c = there + kappa * (x + std::numbers::pi);
    }
}

}  // namespace dumbbell_bench
