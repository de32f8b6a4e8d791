#pragma once

#include <optional>

#include "catch.hpp"
#include "flight/batch/aim.hpp"
#include "flight/batch/place.hpp"
#include "rooms/flight/rays.hpp"

namespace dumbbell_test {

using Place = dumbbell::flight::batch::Place<double>;

/// As far as L39 lets sine, cosine and inverse of a place be off: they are moved by what rounding leaves of
/// it.
inline std::optional<Place> place_at(Random& random, double z, double kappa) {
    const auto at = dumbbell::flight::batch::sin_cos(z);
    const auto off = [&](double most) { return 1 + random.sign() * (random.coin() ? most : 0); };
    if (!(at.cos - kappa > 0x1p-24)) {
        return std::nullopt;
    }
    return Place{z,
                 {at.sin * off(0x1.8p-52), at.cos * off(0x1.8p-52)},
                 1 / (at.cos - kappa) * off(0x1p-17 - 0x1p-20),
                 std::min(at.sin, at.cos) * 0x1p-7 * (1 - 0x1p-40)};
}

/// The place of a step from z, or z itself.
inline std::optional<Place> some_place(Random& random, const DoubleRay& ray, double z) {
    if (random.coin()) {
        return place_at(random, z, ray.kappa);
    }
    const auto [place, near] =
        dumbbell::flight::batch::place_near(z, dumbbell::flight::batch::sin_cos(z), ray.c, ray.kappa);
    return near ? std::optional(place) : std::nullopt;
}

/// The place at which the kernel finds the contact from its own first point, and its bound, in at most ten
/// rounds. Precondition: the ray collides, clearly.
template <class Bound>
Real close_contact(const DoubleRay& ray, const Flight<Real>& exact) {
    namespace batch = dumbbell::flight::batch;
    double z = batch::first_point(ray.c, ray.kappa);
    for (int round = 0; round < 10; ++round) {
        const auto at = batch::sin_cos(z);
        const auto [place, near] = batch::place_near(z, at, ray.c, ray.kappa);
        const auto contact = Bound::contact(place, ray.c, ray.kappa);
        if (near && contact.close) {
            return Real(place.z) + Real(contact.shift);
        }
        const auto aim = batch::step_to_contact(place.z, at, ray.kappa);
        z = aim.at_top ? batch::step_to_top(aim.z, batch::sin_cos(aim.z), ray.c, ray.kappa).z : aim.z;
    }
    FAIL(say("not found:", ray, "x", exact.x, "z", z));
    return Real(0);
}

}  // namespace dumbbell_test
