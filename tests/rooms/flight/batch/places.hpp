#pragma once

#include <catch2/catch.hpp>

#include "flight/batch/aim.hpp"
#include "rooms/flight/rays.hpp"

namespace dumbbell_test {

/// Where a tangent may be laid: at the contact, near it, or anywhere.
inline double some_place(Random& random, const DoubleRay& ray, const Flight<Real>& exact) {
    switch (random.below(4)) {
        case 0:
            return random.uniform(0, dumbbell::half_pi_hi);
        case 1:
            return std::clamp(exact.x.convert_to<double>() * (1 + random.sign() * random.scaled(1e-17, 0.5)),
                              0.0, dumbbell::half_pi_hi);
        default: {
            const auto aim = dumbbell::flight::batch::first_aim(ray.c, ray.kappa);
            return random.coin() ? aim.z
                                 : dumbbell::flight::batch::next_aim(
                                       aim, dumbbell::flight::batch::sin_cos(aim.z), ray.c, ray.kappa)
                                       .z;
        }
    }
}

/// The bound of the contact that the kernel finds from its own first place, in at most ten rounds.
/// Precondition: the ray collides, clearly.
template <class Bound>
Real close_contact(const DoubleRay& ray, const Flight<Real>& exact) {
    auto aim = dumbbell::flight::batch::first_aim(ray.c, ray.kappa);
    auto at = dumbbell::flight::batch::sin_cos(aim.z);
    auto contact = Bound::contact(aim.z, at, ray.c, ray.kappa);
    for (int round = 0; !contact.close || aim.at_top; ++round) {
        if (round == 10) {
            FAIL(say("not found:", ray, "x", exact.x, "z", aim.z));
        }
        aim = dumbbell::flight::batch::next_aim(aim, at, ray.c, ray.kappa);
        at = dumbbell::flight::batch::sin_cos(aim.z);
        contact = Bound::contact(aim.z, at, ray.c, ray.kappa);
    }
    return Real(aim.z) + Real(contact.shift);
}

}  // namespace dumbbell_test
