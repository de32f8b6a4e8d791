// Bodies with mass between their contacts, for the tests of proofs/body.md.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include "simulate.hpp"
#include "trial.hpp"

namespace dumbbell_oracle {

inline constexpr double half_turn = std::numbers::pi;

// rho and Q, and the body of length d1 = 1.
struct Numbers {
    double rho, q;
    template <class S>
    [[nodiscard]] Dumbbell<S> body() const {
        return {S(1), S(rho), S(1) / S(q)};
    }
    [[nodiscard]] double corner() const {
        return half_turn - std::atan(std::sqrt(q)) - std::atan(rho * std::sqrt(q));
    }
    [[nodiscard]] double wedge() const { return half_turn - 2 * std::atan(std::sqrt(q)); }
};

// The tolerance is for the ties at whole numbers.
template <class S>
[[nodiscard]] std::size_t whole_from(const S& x) {
    using std::ceil;
    return static_cast<std::size_t>(ceil(x - (std::is_same_v<S, double> ? 1e-9 : 1e-14)));
}

// The mass ratio q with a uniform rod of mu times the mass of both ends (L70 (d)).
[[nodiscard]] inline Numbers rod(double q, double mu) {
    const double d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
    const double rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
    return {rho, d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)))};
}

// On the floor just after a collision, at the corner distance e of the right corner: to its right the light
// end stands there, to its left the heavy one. The velocity has this angle in the metric of the kinetic
// energy.
template <class S>
[[nodiscard]] Contact<S> standing(const Dumbbell<S>& body, Mass mass, double e, double angle) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    State<S> state{pi<S>() + (mass == Mass::light ? S(e) : S(-e)), cos(S(angle)) / sqrt(body.inertia()), 0,
                   sin(S(angle))};
    state.y = -body.arm(mass) * sin(state.phi);
    return {mass, body.climb(mass, state) > 0 ? state : reversed(state)};
}

struct Spot {
    Mass mass;
    double e, angle;
};

[[nodiscard]] inline Spot random_spot(Sampler& sampler) {
    const double e = sampler.coin() ? sampler.log_uniform(1e-3, 1.57) : sampler.uniform(1e-3, 1.57);
    return {sampler.coin() ? Mass::light : Mass::heavy, e, sampler.uniform(0, half_turn)};
}

template <class S>
[[nodiscard]] std::size_t total_at(const Numbers& n, const Spot& at) {
    const auto body = n.body<S>();
    return total_collisions(body, standing(body, at.mass, at.e, at.angle)).collisions;
}

// Where long double finds more than `most`, 80 digits decide.
[[nodiscard]] inline std::size_t counted_at(const Numbers& n, const Spot& at, std::size_t most) {
    const std::size_t found = total_at<long double>(n, at);
    return found > most ? total_at<Digits80>(n, at) : found;
}

}  // namespace dumbbell_oracle
