#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "propagation.hpp"

/// Orbits on which enclosures are hard to keep, by their first departure from a light wall.
namespace dumbbell_test {

struct HardOrbit {
    std::string name;
    double x, kappa, r;
};

template <class I>
WallState<I> point(const HardOrbit& orbit) {
    return {I(orbit.x), I(orbit.kappa)};
}

/// Upwards from the point: 2^-(bits - 13) wide in x and, in units of r, in kappa. 13 bits are left for
/// rounding.
template <class I>
WallState<I> small_box(const HardOrbit& orbit, int bits) {
    const I width(std::ldexp(1.0, 13 - bits));
    const WallState<I> at = point<I>(orbit);
    return {hull(at.x, at.x + width), hull(at.kappa, at.kappa + I(orbit.r) * width)};
}

/// The number of collisions after the departure.
inline std::size_t length(const HardOrbit& orbit) {
    const dumbbell::PrecisionScope scope(256);
    return propagate(Form::monotone, point<dumbbell::BigInterval>(orbit), dumbbell::BigInterval(orbit.r))
        .collisions();
}

/// A start from which the last collision only just happens: 1e-11 (relatively) below the place from which
/// that flight passes over the hump.
inline HardOrbit grazing_orbit() {
    constexpr double r = 0.01;
    const auto from = [](double x) { return HardOrbit{"grazing", x, r, r}; };
    double hits = 0.01;
    double misses = 0.2;
    const std::size_t many = length(from(hits));
    for (int i = 0; i < 60; ++i) {
        const double middle = (hits + misses) / 2;
        (length(from(middle)) == many ? hits : misses) = middle;
    }
    return from(hits * (1 - 1e-11));
}

inline std::vector<HardOrbit> hard_orbits() {
    return {
        {"easy", 0.5, -0.1, 0.1},
        grazing_orbit(),
        {"near the corner", 0.0031458, -1e-3, 1e-3},  // descends to x = 1e-6 above the far corner
        {"near the peak", 0x1.921fb54442d18p+0 - 0.017, -0.0145, 1e-4},  // just above the wall's tangent
        {"q = 1e6", 1e-3, 1e-6, 1e-6},
        {"long descent", 1.2, -0.0013, 1e-6},
    };
}

}  // namespace dumbbell_test
