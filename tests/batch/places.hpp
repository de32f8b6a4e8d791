#pragma once

#include "batch/aim.hpp"
#include "rays.hpp"

namespace dumbbell_test {

/// Where a tangent may be laid: at the contact, near it, or anywhere.
inline double some_place(Random& random, const PlainRay& ray, const Flight<Real>& exact) {
    switch (random.below(4)) {
        case 0:
            return random.uniform(0, dumbbell::half_pi_hi);
        case 1:
            return std::clamp(exact.x.convert_to<double>() * (1 + random.sign() * random.scaled(1e-17, 0.5)),
                              0.0, dumbbell::half_pi_hi);
        default: {
            const auto aim = dumbbell::batch::first_aim(ray.c, ray.kappa);
            return random.coin()
                       ? aim.z
                       : dumbbell::batch::next_aim(aim, dumbbell::batch::sin_cos(aim.z), ray.c, ray.kappa).z;
        }
    }
}

}  // namespace dumbbell_test
