#pragma once

#include "flight/ray.hpp"
#include "reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"

namespace dumbbell_test {

/// A ray in doubles, exactly.
struct DoubleRay {
    double c, kappa, r;
};

template <class I>
dumbbell::flight::Ray<I> as(const DoubleRay& ray) {
    return {I(ray.c), I(ray.kappa), I(ray.r)};
}
/// 2^-n at the working precision, also where a double has none.
inline dumbbell::BigInterval power_of_half(int n) { return dumbbell::two_to(-n); }
template <class T>
RayCount<T> ray_count(const DoubleRay& ray, long cap = 1'000'000) {
    return ray_count<T>(T(ray.c), T(ray.kappa), T(ray.r), cap);
}
inline std::string show(const DoubleRay& ray) { return say("c", ray.c, "kappa", ray.kappa, "r", ray.r); }

/// 1/q: ordinary, small, 1 or close to 1.
inline double random_r(Random& random, double least_r = 1e-5) {
    switch (random.below(5)) {
        case 0:
            return 1;
        case 1:
            return 1 - random.scaled(1e-15, 0.1);
        default:
            return random.scaled(least_r, 1);
    }
}

/// A ray that nearly touches the wall: `margin` is by how much c lies above (or, negative, below) the
/// tangency, relatively.
inline DoubleRay grazing_ray(double kappa, double margin, double r) {
    const Real top = kappa <= 0 ? Real(pi_in<Real>() / 2) : Real(acos(Real(kappa)));
    const Real c = (sin(top) - kappa * top) * (1 + Real(margin));
    return {std::max(0.0, c.convert_to<double>()), kappa, r};
}

/// A ray of c >= 0 and kappa in [-r, 1): anywhere, tiny, grazing, near the corner, near the peak, nearly too
/// steep.
inline DoubleRay random_ray(Random& random, double least_r = 1e-5) {
    const double r = random_r(random, least_r);
    switch (random.below(8)) {
        case 0:
            return {random.uniform(0, 1), random.uniform(-r, 1), r};
        case 1:
            return {random.scaled(1e-12, 1), random.scaled(1e-12, 0.9), r};
        case 2:
            return grazing_ray(random.uniform(-r, 0.999), random.sign() * random.scaled(1e-17, 1e-3), r);
        case 3: {  // near the peak
            const double x = 0x1.921fb54442d18p+0 - random.scaled(1e-9, 0.3);
            const double kappa = std::max(-r, std::cos(x) - random.scaled(1e-12, 0.3));
            return {std::max(0.0, std::sin(x) - kappa * x), kappa, r};
        }
        case 4:  // near the corner
            return {random.scaled(1e-300, 1e-6), random.coin() ? 0.0 : random.uniform(-r, 1), r};
        case 5: {  // steep
            const double slack = random.scaled(1e-16, 0.1);
            return {std::pow(slack, 1.5) * random.uniform(0, 1.1), 1 - slack, r};
        }
        case 6:
            return {0, random.coin() ? r * random.uniform(-1, 1) : random.uniform(0, 1), r};
        default:  // few units of r: what the bridge sends out
            return {r * random.uniform(0, 5), std::min(0.99, r * random.uniform(-1, 2)), r};
    }
}

}  // namespace dumbbell_test
