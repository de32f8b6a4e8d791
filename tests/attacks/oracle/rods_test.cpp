// proofs/body.md against the simulation: bodies with mass between their contacts.
#include "rods.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "catch.hpp"

using namespace dumbbell_oracle;

namespace {

Numbers random_numbers(Sampler& sampler) {
    const double rho = sampler.coin() ? sampler.log_uniform(0.03, 1) : sampler.uniform(0.3, 1);
    return {rho, (sampler.coin() ? 1 + sampler.log_uniform(1e-4, 1) : sampler.log_uniform(1, 30)) / rho};
}

// The slope d yhat / |d psi| (yhat = y, as d1 = 1).
double steepness_of(const State<long double>& s) { return static_cast<double>(s.ydot / std::abs(s.phidot)); }

}  // namespace

TEST_CASE("L70: masses between the contacts have Q rho >= 1, and rods the stated numbers") {
    Sampler sampler(1, 7001);
    for (int i = 0; i < scaled(2'000); ++i) {
        const double q = sampler.log_uniform(1, 100), mu = sampler.log_uniform(1e-4, 100);
        std::vector<std::array<double, 2>> parts{{0, 1 / (1 + q)}, {1, q / (1 + q)}};  // place and mass
        constexpr int slices = 2000;
        for (int k = 0; k < slices; ++k) parts.push_back({(k + 0.5) / slices, mu / slices});
        double mass = 0, centre = 0, square = 0;
        for (const auto& [x, m] : parts) mass += m, centre += m * x / (1 + mu);
        for (const auto& [x, m] : parts) square += m * (x - centre) * (x - centre) / mass;
        const double rho = (1 - centre) / centre, inertia = centre * centre / square;
        const double d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
        const double stated = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
        CHECK(rho == Approx(stated).epsilon(1e-5));
        CHECK(inertia == Approx(d1 * d1 / (d1 * d1 * stated - mu / (6 * (1 + mu)))).epsilon(1e-5));
        CHECK(inertia * rho > 1);
    }
}

TEST_CASE("L71: after a contact with the bridge a ray goes on by E and P, wherever it is") {
    Sampler sampler(1, 7002);
    int back = 0, again = 0;
    for (int i = 0; i < scaled(5'000); ++i) {
        const Numbers n = random_numbers(sampler);
        const auto body = n.body<long double>();
        const double t = sampler.uniform(0, half_turn), s = std::cos(t);
        const double kappa = n.rho * s - sampler.log_uniform(1e-3, 3), g = 1 / (n.q * n.rho);
        State<long double> before{pi<long double>() - t, -1, 0, kappa};
        before.y = -body.arm(Mass::heavy) * std::sin(before.phi);
        const auto after = body.bounce(Mass::heavy, before);
        const double e = g + 2 * s * kappa - n.rho * s * s, p = 2 * s / n.q - kappa * (g - n.rho * s * s);
        if (std::abs(e) < 1e-6) continue;
        CHECK((after.phidot < 0) == (e > 0));
        CHECK(steepness_of(after) == Approx(p / std::abs(e)).epsilon(1e-9));
        back += e < 0 ? 1 : 0;
        const auto later = simulate(body, after, Mass::heavy).collisions;
        again += std::any_of(later.begin(), later.end(), [](const auto& c) { return c.mass == Mass::heavy; });
    }
    CHECK(back > 200);
    CHECK(again > 50);  // what a massless rod excludes
}

TEST_CASE("L74: the two rays of a contact with the bridge") {
    Sampler sampler(1, 7003);
    for (int i = 0; i < scaled(2'000); ++i) {
        const Numbers n = random_numbers(sampler);
        const auto body = n.body<long double>();
        const double e = sampler.uniform(0, half_turn / 2), s = std::cos(e),
                     eta = sampler.log_uniform(1e-6, 5);
        State<long double> after{pi<long double>() - e, -1, 0, n.rho * (s + eta)};
        after.y = -body.arm(Mass::heavy) * std::sin(after.phi);
        const auto reverse = reversed(body.bounce(Mass::heavy, after));
        const double big = n.q * n.rho * n.rho;
        const double steep = eta * (1 + big * s * s) / (1 + big * s * s + 2 * big * s * eta);
        CHECK(reverse.phidot > 0);
        CHECK(steepness_of(reverse) == Approx(n.rho * (steep - s)).epsilon(1e-9).margin(1e-12));
    }
}
