#include "adiabatic/bounce_leaf.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

TEST_CASE("L38: both errors and the next contact are enclosed over boxes") {
    Samples samples(8);
    int next_ones = 0;
    for (int i = 0; i < 4000; ++i) {
        const double width = samples.log_uniform(1e-10, 0.03);
        const Interval delta = samples.around(samples.log_uniform(1e-3, 0.1), width);
        const Interval u = samples.around(samples.uniform(1.2 * delta.hi(), 1.5), width);
        const Interval s = samples.around(samples.uniform(0, 0.97), width);
        const adiabatic::Bounce<Interval> bounce(u, s, adiabatic::Masses<Interval>(delta));
        const PointMasses m(samples.in(delta));
        const long double x = half_turn / 2 - samples.in(u), fall = samples.in(s),
                          kappa = -m.delta * fall / m.beta2;
        const long double w = std::cos(x), d = w * w - 2 * kappa * w - m.r;
        if (!(d > 0)) continue;
        CAPTURE(i, static_cast<double>(x), static_cast<double>(fall), static_cast<double>(m.delta));
        const long double spin = d / (w * w + m.r), y = m.beta2 * std::sin(x);
        const long double root = std::sqrt(1 - y * y);
        const long double speed = std::abs(spin - 1 + 2 * -m.delta * fall / root);
        CHECK(bounce.speed_error().hi() >= speed - 1e-15L);
        CHECK(bounce.speed_error().lo() <= speed + 1e-15L);
        const auto next = next_contact(bounce);
        if (!next) continue;
        const long double slope = kappa + 2 * w * (m.r + kappa * kappa) / d;
        const long double c = std::sin(x) + slope * (x + half_turn);
        if (slope >= 1 || c < 0) continue;
        const long double top = slope > 0 ? std::acos(slope) : half_turn / 2;
        if (std::sin(top) <= c + slope * top) continue;  // it misses
        CHECK_FALSE(next->none);
        const long double at = root_below(c - slope * half_turn / 2, slope, top);
        CHECK(next->x.lo() <= at + 1e-13L);
        CHECK(next->x.hi() >= at - 1e-13L);
        CHECK(holds(next->slope, slope));
        const long double height =
            std::abs(m.beta2 * (std::sin(at) - std::sin(x)) + 2 * f_at(x, m) * m.delta * fall);
        CHECK(height_error(bounce, *next).hi() >= height - 1e-13L);
        CHECK(height_error(bounce, *next).lo() <= height + 1e-13L);
        ++next_ones;
    }
    CHECK(next_ones > 1000);
}
