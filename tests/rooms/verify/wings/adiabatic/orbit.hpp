// Orbits of the physical dumbbell for the tests of the adiabatic claims, from the oracle's mechanics of two
// points on a rod.
#pragma once
#include <gmpxx.h>

#include <cmath>
#include <optional>
#include <random>

#include "attacks/oracle/simulate.hpp"

namespace make {

using Real = long double;
constexpr Real pi_real = 3.14159265358979323846264338327950288L;

/// A collision of the light mass at distance u of the rod from the vertical, just before which |phidot| = 1
/// and ydot = -delta s, and all that follow.
class AdiabaticOrbit {
  public:
    AdiabaticOrbit(Real u, Real s, Real delta, bool forwards = true)
        : body_((1 - delta * delta) / (delta * delta)) {
        const Real x = pi_real / 2 - u, y = body_.beta2() * std::sin(x);
        before_ = {forwards ? pi_real + x : -x, forwards ? 1.0L : -1.0L, y, -delta * s};
        const auto after = body_.bounce(dumbbell_oracle::Mass::light, before_);
        collisions_.push_back({0, dumbbell_oracle::Mass::light, before_, after});
        const auto run = dumbbell_oracle::simulate(body_, after, dumbbell_oracle::Mass::light);
        collisions_.insert(collisions_.end(), run.collisions.begin(), run.collisions.end());
    }

    [[nodiscard]] std::size_t size() const { return collisions_.size(); }
    [[nodiscard]] bool light(std::size_t i) const {
        return collisions_.at(i).mass == dumbbell_oracle::Mass::light;
    }
    [[nodiscard]] Real u(std::size_t i) const {
        return std::asin(std::abs(std::cos(collisions_.at(i).before.phi)));
    }
    [[nodiscard]] Real y(std::size_t i) const { return collisions_.at(i).before.y; }
    [[nodiscard]] Real spin_before(std::size_t i) const { return std::abs(collisions_.at(i).before.phidot); }
    [[nodiscard]] Real spin_after(std::size_t i) const { return std::abs(collisions_.at(i).after.phidot); }
    [[nodiscard]] Real f(std::size_t i) const { return pi_real - std::acos(y(i)); }
    [[nodiscard]] Real I_before(std::size_t i) const { return spin_before(i) * f(i); }
    [[nodiscard]] Real I_after(std::size_t i) const { return spin_after(i) * f(i); }
    /// No collision comes before the first.
    [[nodiscard]] bool is_whole() const {
        return dumbbell_oracle::simulate(body_, reversed(before_), dumbbell_oracle::Mass::light)
            .collisions.empty();
    }

  private:
    dumbbell_oracle::Dumbbell<Real> body_;
    dumbbell_oracle::State<Real> before_{};
    std::vector<dumbbell_oracle::Collision<Real>> collisions_;
};

inline std::mt19937_64& engine() {
    static std::mt19937_64 random(2026);
    return random;
}
inline double uniform(double lo, double hi) { return std::uniform_real_distribution<>(lo, hi)(engine()); }
/// A number of [lo, hi], often an end.
inline Real within(const mpq_class& lo, const mpq_class& hi) {
    const double a = lo.get_d(), b = hi.get_d();
    return engine()() % 3 == 0 ? a : engine()() % 2 == 0 ? b : uniform(a, b);
}

}  // namespace make
