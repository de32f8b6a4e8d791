// The natural measure on incoming trajectories, by a gas of dumbbells and by the simulation.
#include <cmath>
#include <map>
#include <random>

#include "catch.hpp"
#include "simulate.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

/// The state at the height yhat with this angle and direction.
State<Real> incoming(const Dumbbell<Real>& body, Real phi, Real s, Real yhat) {
    return {phi, s * std::sqrt(body.ratio() / (1 - s * s)), yhat * body.beta2(), -body.beta2()};
}

}  // namespace

TEST_CASE("L61: the height of the section does not matter, but for a shear") {
    Sampler sampler(1, 61);
    for (int i = 0; i < scaled(3000); ++i) {
        const Dumbbell<Real> body(std::exp(sampler.uniform(0, 7)));
        const Real phi = sampler.uniform(0, 6.28), s = sampler.uniform(-0.99, 0.99),
                   rise = sampler.uniform(0, 3);
        const State<Real> low = incoming(body, phi, s, 1.001L);
        const auto from_low = simulate(body, low);
        const auto from_high = simulate(body, incoming(body, phi - low.phidot * rise, s, 1.001L + rise));
        INFO(say("q", body.ratio(), "phi", phi, "s", s, "rise", rise));
        CHECK((from_low.care.doubtful() || from_low.collisions.size() == from_high.collisions.size()));
        CHECK((from_low.care.doubtful() || !from_low.collisions.empty()));
    }
}

TEST_CASE("L61: the mirror image has as many collisions") {
    Sampler sampler(1, 62);
    for (int i = 0; i < scaled(3000); ++i) {
        const Dumbbell<Real> body(std::exp(sampler.uniform(0, 7)));
        const Real phi = sampler.uniform(0, 6.28), s = sampler.uniform(-0.99, 0.99);
        const auto one = simulate(body, incoming(body, phi, s, 2));
        const auto other = simulate(body, incoming(body, pi<Real>() - phi, -s, 2));
        INFO(say("q", body.ratio(), "phi", phi, "s", s));
        CHECK((one.care.doubtful() || one.collisions.size() == other.collisions.size()));
    }
}

TEST_CASE("L61: a gas of dumbbells arrives evenly in phi and in s, with any horizontal motion") {
    std::mt19937_64 engine(63);
    Sampler sampler(1, 63);
    std::normal_distribution<double> normal;
    constexpr int cells = 5;
    std::array<int, cells * cells> found{};
    int arrived = 0;
    while (arrived < scaled(200'000)) {
        // Velocities of one kinetic energy in the metric (x, psi, z), all equally likely; heights up to as
        // far as any of them falls in the time 1; angles anywhere.
        const Real x = normal(engine), spin = normal(engine), fall = normal(engine);
        const Real speed = std::sqrt(x * x + spin * spin + fall * fall);
        const Real psi = sampler.uniform(0, 2 * pi<double>()), height = sampler.uniform(0, 1);
        const Real down = -fall / speed;  // in z = sqrt(q) yhat
        if (down < height) {
            continue;
        }
        const Real angle = psi + spin / speed * (height / down), s = spin / std::hypot(spin, fall);
        const Real turns = angle / (2 * pi<Real>());
        const auto column = static_cast<std::size_t>((turns - std::floor(turns)) * cells);
        const auto row = static_cast<std::size_t>((s + 1) / 2 * cells);
        ++found.at(std::min<std::size_t>(row, cells - 1) * cells + std::min<std::size_t>(column, cells - 1));
        ++arrived;
    }
    const double mean = static_cast<double>(arrived) / (cells * cells);
    for (const int count : found) {
        CHECK(std::abs(count - mean) < 6 * std::sqrt(mean));
    }
}
