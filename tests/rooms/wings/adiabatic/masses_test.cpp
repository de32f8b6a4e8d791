#include "adiabatic/masses.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

TEST_CASE("The masses of a range of delta enclose those of each delta, from 0 on") {
    Samples samples(1);
    for (int i = 0; i < 2000; ++i) {
        const double lo = samples.uniform(0, 1) < 0.1 ? 0 : samples.log_uniform(1e-6, 0.5);
        const Interval delta(lo, lo + samples.log_uniform(1e-9, 0.1));
        const adiabatic::Masses<Interval> masses(delta);
        const PointMasses m(samples.in(delta));
        CAPTURE(lo, static_cast<double>(m.delta));
        CHECK(holds(masses.beta2, m.beta2));
        CHECK(holds(masses.r, m.r));
        CHECK(holds(masses.root_r, std::sqrt(m.r)));
        CHECK(holds(masses.delta_over_beta2, m.delta / m.beta2));
    }
}

TEST_CASE("Powers of delta are those of sixteenths") {
    for (const double delta : {0.0, 1e-4, 0.01, 0.3, 1.0}) {
        for (int k = 0; k <= 32; ++k) {
            CAPTURE(delta, k);
            CHECK(holds(adiabatic::delta_power(Interval(delta), k),
                        std::pow(static_cast<long double>(delta), k / 16.0L)));
        }
    }
}
