#include "adiabatic/pair_leaf.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

namespace {

Pair<Interval> pair_of(double u, double s, double v, double delta) {
    return {Interval(u), Interval(s), Interval(v), Masses<Interval>(Interval(delta))};
}

/// S conserved: a density of 0.
const Potential<Interval>& no_drift() {
    static const Potential<Interval> potential({{Interval(0.01), Interval(0)}});
    return potential;
}

}  // namespace

TEST_CASE(
    "L36: without drift the error of a run is that of the two slopes that S leaves at the later collision") {
    Samples samples(7);
    int possible = 0;
    for (int i = 0; i < 3000; ++i) {
        const double delta = samples.log_uniform(0.001, 0.05), u = samples.uniform(0.3, 1.3),
                     v = samples.uniform(0.3, 1.3);
        const double s = samples.uniform(0, 1);
        const auto pair = pair_of(u, s, v, delta);
        const auto error = run_error(pair, Interval(0.8), no_drift());
        const PointMasses m(delta);
        const long double kappa0 = -m.delta * s / m.beta2,
                          energy = 1 + static_cast<long double>(s) * s / m.beta2;
        const long double x0 = half_turn / 2 - u, x1 = half_turn / 2 - v, share = h_at(x0, kappa0, m);
        // By halving in the slope on either side of the greatest share, sigma = -sqrt(r)/w.
        const long double w = std::cos(x1), root_r = std::sqrt(m.r), top = -root_r / w;
        const auto at = [&](long double sigma) {
            return std::sqrt(energy / (1 + sigma * sigma)) * h_at(x1, sigma * root_r, m);
        };
        if (at(top) < share) {
            if (error) CHECK(error->hi() == 0);
            continue;
        }
        long double worst = 0;
        for (const long double end : {-50.0L, 50.0L}) {
            long double inner = top, outer = end;
            for (int j = 0; j < 100; ++j) {
                const long double middle = (inner + outer) / 2;
                (at(middle) > share ? inner : outer) = middle;
            }
            const long double invariant = std::sqrt(energy / (1 + inner * inner)) * f_at(x1, m);
            worst = std::max(worst, std::abs(invariant - f_at(x0, m)) / m.delta);
        }
        if (!error) continue;
        CAPTURE(i, delta, u, v, s);
        CHECK(error->hi() >= worst - 1e-9L / m.delta);
        CHECK(error->hi() <= worst * (1 + 1e-6L) + 1e-6L);
        ++possible;
    }
    CHECK(possible > 300);
}

TEST_CASE("A class bounds nothing where S is not certainly above its J") {
    const auto pair = pair_of(0.5, 1, 0.5, 0.01);
    CHECK(run_error(pair, Interval(1.5), no_drift()).has_value());
    CHECK_FALSE(run_error(pair, Interval(2.5), no_drift()).has_value());
}

TEST_CASE("L37: where the flights could touch the bridge no scattering is bounded") {
    CHECK(certainly_above_bridge(pair_of(0.2, 1, 0.1, 0.01)));
    CHECK_FALSE(certainly_above_bridge(pair_of(1.4, 1, 0.1, 0.01)));
    CHECK(scattering_error(pair_of(0.2, 1, 0.1, 0.01), Interval(0.8), no_drift()).has_value());
    CHECK_FALSE(scattering_error(pair_of(1.4, 1, 1.39, 0.01), Interval(0.8), no_drift()).has_value());
}

TEST_CASE("A collision far from the vertical is not the first one") {
    CHECK(certainly_not_first(pair_of(0.5, 1, 0.1, 0.01)));
    CHECK_FALSE(certainly_not_first(pair_of(0.2, 1, 0.1, 0.01)));
}
