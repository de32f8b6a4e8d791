#include "adiabatic/contact.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

TEST_CASE("L33: the share of the mean invariant and its half step are enclosed over boxes") {
    Samples samples(2);
    for (int i = 0; i < 3000; ++i) {
        const Interval delta = samples.around(samples.log_uniform(1e-4, 0.3), 0.1);
        const Interval x = samples.around(samples.uniform(0.01, 1.3), 0.05);
        const double k = samples.uniform(-0.2, 0.1);
        const Interval slope(std::min(k, k * 1.1), std::max(k, k * 1.1));
        const Masses<Interval> masses(delta);
        const PointMasses m(samples.in(delta));
        const long double at = samples.in(x), kappa = samples.in(slope), w = std::cos(at);
        const auto contact = light_contact(x, masses.beta2);
        CAPTURE(static_cast<double>(at), static_cast<double>(kappa), static_cast<double>(m.delta));
        CHECK(holds(contact.f, f_at(at, m)));
        CHECK(holds(contact.F, half_turn / 2 + at));
        CHECK(holds(mean_share(contact, slope, masses.r), h_at(at, kappa, m)));
        if (certainly_positive(contact.w - slope)) {
            const long double g = (m.r + kappa * w) / (w * (w - kappa));
            CHECK(holds(half_step(contact.w, slope, slope / delta, masses.delta_over_beta2) * delta, g));
        }
    }
}
