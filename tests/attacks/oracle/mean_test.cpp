// proofs/theorem.md, Theorem 6, and L85 of body.md: the mean number of collisions of incoming trajectories,
// by the simulation.
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <map>
#include <random>

#include "catch.hpp"
#include "law.hpp"
#include "rods.hpp"

using namespace dumbbell_oracle;

namespace {

/// E(-m) = (1 + m)^(1/2) E(m/(1 + m)); Boost's argument is the modulus.
Real arc_of(Real m) { return std::sqrt(1 + m) * boost::math::ellint_2(std::sqrt(m / (1 + m))); }

}  // namespace

TEST_CASE("theorem 6, L85: each end hits the floor as often on average as its part of the floor is long") {
    const Numbers tried[] = {{1, 1}, {1 / 4.61, 4.61}, {0.1, 10},   {0.01, 100}, {0.001, 1000},
                             {1, 4}, {0.5, 9},         {0.3, 1000}, {0.5, 0.5}};
    for (const Numbers& n : tried) {
        std::mt19937_64 engine(606);
        std::uniform_real_distribution<double> uniform(0, 1);
        const auto body = n.body<Real>();
        const long count = scaled(n.q < 500 ? 8'000 : 800);
        const std::map<Mass, Real> stated{{Mass::light, arc_of(n.q) / pi<Real>()},
                                          {Mass::heavy, arc_of(n.q * n.rho * n.rho) / pi<Real>()}};
        std::map<Mass, Real> sum, squares;
        for (int i = 0; i < count; ++i) {
            const Real phi = 2 * pi<Real>() * uniform(engine), s = 2 * uniform(engine) - 1;
            const State<Real> from{phi, s * std::sqrt(n.q), 1.5L, -std::sqrt(1 - s * s)};
            std::map<Mass, Real> times;
            for (const auto& collision : simulate(body, from).collisions) ++times[collision.mass];
            if (times[Mass::heavy] > 1 && std::abs(n.rho * n.q - 1) < 1e-9)
                FAIL(say("q", n.q, phi, s, "twice"));
            for (const auto& [mass, k] : times) sum[mass] += k, squares[mass] += k * k;
        }
        for (const auto& [mass, exact] : stated) {
            const Real mean = sum[mass] / count,
                       error = std::sqrt((squares[mass] / count - mean * mean) / count);
            INFO(say("rho", n.rho, "Q", n.q, "light", mass == Mass::light, mean, "+-", error, exact));
            CHECK(std::abs(mean - exact) < 4.5L * error);
        }
    }
}

TEST_CASE("conjecture: the number of collisions of an incoming trajectory is near to that of its direction") {
    const auto phi_of = [](Real s) {
        return law::integral<Real>([&](const Real& t) { return std::sin(pi<Real>() * s / std::cos(t)); },
                                   std::acos(std::min<Real>(1, 2 * s)), std::acos(s));
    };
    const auto apart = [&](Real q, long count) {  // the mean of |n/sqrt q - Phi|
        std::mt19937_64 engine(607);
        std::uniform_real_distribution<double> uniform(0, 1);
        const Dumbbell<Real> body(q);
        Real sum = 0;
        for (int i = 0; i < count; ++i) {
            const Real s = (static_cast<Real>(i) + uniform(engine)) / count,
                       phi = 2 * pi<Real>() * uniform(engine);
            const State<Real> from{phi, s * std::sqrt(q), 1.5L * body.beta2(),
                                   -std::sqrt(1 - s * s) * body.beta2()};
            const auto n = static_cast<Real>(simulate(body, from).collisions.size());
            sum += std::abs(n / std::sqrt(q) - phi_of(s));
        }
        return sum / count;
    };
    const Real first = apart(100, scaled(1000)), second = apart(1e4L, scaled(100)),
               third = apart(1e6L, scaled(20));
    INFO(say("apart", first, second, third));
    CHECK(first < 0.2L);
    CHECK(second < first / 2);
    CHECK(third < second / 2);
}
