// The extremal orbits of proofs/theorem.md, flight by flight, in plain numbers.
#pragma once

#include <vector>

#include "ray_count.hpp"
#include "scalar.hpp"

namespace dumbbell_oracle {

template <class S>
[[nodiscard]] Ray<S> top_ray(const S& r) {  // horizontal, tangent to the bridge at its top
    return {r, S(0)};
}
template <class S>
[[nodiscard]] Ray<S> corner_ray(const S& r) {  // from the corner along the bridge's tangent there
    return {S(pi<S>() * r), r};
}

// All flights of the iteration G: those that collide, and the last one if it exists.
template <class S>
[[nodiscard]] std::vector<Ray<S>> flights(Ray<S> ray, const S& r) {
    std::vector<Ray<S>> all{ray};
    for (;;) {
        const auto taken = step(all.back(), r);
        if (!taken || !taken->next) return all;
        all.push_back(*taken->next);
    }
}

template <class S>
[[nodiscard]] std::size_t count_left(const S& e, const S& r) {  // f_L of L21
    return ray_count(bridge_ray(BridgeState<S>{e, S(0)}, r), r);
}
template <class S>
[[nodiscard]] std::size_t count_right(const S& e, const S& r) {  // f_R of L21
    return ray_count(bridge_ray_reversed(BridgeState<S>{e, S(0)}, r), r);
}

// The critical ratio of N >= 3, enclosed by bisection on the count of one extremal orbit: the count is k or
// more at `above`, less at `below`.
template <class S>
struct CriticalRatio {
    S below;
    S above;
};
[[nodiscard]] inline std::size_t orbit_count(std::size_t n) { return n % 2 == 1 ? (n - 1) / 2 : (n - 2) / 2; }
template <class S>
[[nodiscard]] Ray<S> orbit_of(std::size_t n, const S& r) {  // odd N: the top orbit, even N: the corner orbit
    return n % 2 == 1 ? top_ray(r) : corner_ray(r);
}
template <class S>
[[nodiscard]] CriticalRatio<S> bisect_critical(std::size_t n, S below, S above, int rounds) {
    for (int i = 0; i < rounds; ++i) {
        const S middle = (below + above) / 2;
        const S r = 1 / middle;
        (ray_count(orbit_of(n, r), r) >= orbit_count(n) ? above : below) = middle;
    }
    return {below, above};
}
[[nodiscard]] inline CriticalRatio<long double> critical_ratio(std::size_t n) {
    const auto size = static_cast<long double>(n);
    return bisect_critical<long double>(n, 1, 10 + 3 * size * size, 62);
}

}  // namespace dumbbell_oracle
