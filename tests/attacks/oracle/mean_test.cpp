// proofs/theorem.md, Theorem 6: the mean number of collisions of incoming trajectories, by the simulation.
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "law.hpp"
#include "simulate.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

/// E(-m) = (1 + m)^(1/2) E(m/(1 + m)); Boost's argument is the modulus.
Real arc_of(Real m) { return std::sqrt(1 + m) * boost::math::ellint_2(std::sqrt(m / (1 + m))); }

}  // namespace

TEST_CASE("theorem 6: each mass hits the floor as often on average as its part of the floor is long") {
    for (const auto& [q, samples] :
         {std::pair(1.0L, 8'000), {4.61L, 8'000}, {10.0L, 8'000}, {100.0L, 4'000}, {1000.0L, 800}}) {
        std::mt19937_64 engine(606);
        std::uniform_real_distribution<double> uniform(0, 1);
        const Dumbbell<Real> body(q);
        const long count = scaled(samples);
        Real light = 0, squares = 0, heavy = 0;
        for (int i = 0; i < count; ++i) {
            const Real phi = 2 * pi<Real>() * uniform(engine), s = 2 * uniform(engine) - 1;
            const State<Real> from{phi, s * std::sqrt(q), 1.5L * body.beta2(),
                                   -std::sqrt(1 - s * s) * body.beta2()};
            Real of_light = 0, of_heavy = 0;
            for (const auto& collision : simulate(body, from).collisions)
                (collision.mass == Mass::light ? of_light : of_heavy) += 1;
            if (of_heavy > 1) FAIL(say("q", q, "phi", phi, "s", s, "the heavy mass twice"));
            light += of_light;
            squares += of_light * of_light;
            heavy += of_heavy;
        }
        const Real mean = light / count, share = heavy / count;
        const Real error = std::sqrt((squares / count - mean * mean) / count);
        INFO(say("q", q, "light", mean, "+-", error, "heavy", share));
        CHECK(std::abs(mean - arc_of(q) / pi<Real>()) < 4.5L * error);
        CHECK(std::abs(share - arc_of(1 / q) / pi<Real>()) < 4.5L * std::sqrt(share * (1 - share) / count));
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
