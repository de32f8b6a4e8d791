#include "adiabatic/orbit.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

namespace {

/// The same step in long double, the contact by halving.
struct Point {
    PointMasses m;
    long double x, kappa, spin = 1;

    void advance() {
        const long double w = std::cos(x), d = w * w - 2 * kappa * w - m.r;
        const long double next = (kappa * w * w + 2 * m.r * w - m.r * kappa) / d;
        const long double c = std::sin(x) + next * (x + half_turn);
        spin *= d / (w * w + m.r);
        x = root_below(c - next * half_turn / 2, next, next > 0 ? std::acos(next) : half_turn / 2);
        kappa = next;
    }
};

}  // namespace

TEST_CASE("An enclosed orbit contains the simulated one, collision by collision, and stays thin") {
    Samples samples(6);
    for (int i = 0; i < 40; ++i) {
        const double delta = samples.log_uniform(0.003, 0.05), u = samples.uniform(0.3, 1.2),
                     s = samples.uniform(0, 1);
        Orbit<Interval> orbit{Interval(u), Interval(s), Interval(delta)};
        const PointMasses m(delta);
        Point point{m, half_turn / 2 - u, -m.delta * s / m.beta2};
        const long double first = f_at(point.x, m);
        while (orbit.advance()) {
            point.advance();
            CAPTURE(i, delta, u, s);
            REQUIRE(orbit.at().x.lo() <= point.x + 1e-12L);
            REQUIRE(orbit.at().x.hi() >= point.x - 1e-12L);
            REQUIRE(std::abs(approximate(orbit.change()) - (point.spin * f_at(point.x, m) - first)) < 1e-8L);
            if (orbit.angle().lo() < 0.2) break;
            REQUIRE(width(orbit.change()) < 1e-8);
        }
    }
}

TEST_CASE("An orbit begins where its reversed ray misses, and ends where it leaves over the peak") {
    // Far from the vertical another collision came before.
    CHECK_FALSE(Orbit<Interval>(Interval(0.5), Interval(1), Interval(0.01)).certainly_begins());
    CHECK(Orbit<Interval>(Interval(0.2), Interval(1), Interval(0.01)).certainly_begins());
    CHECK_FALSE(Orbit<Interval>(Interval(0.2), Interval(1), Interval(0.01)).certainly_ends());
    // So near the vertical the rod goes on in its old direction.
    CHECK(Orbit<Interval>(Interval(0.001), Interval(0.1), Interval(0.01)).certainly_ends());
}

TEST_CASE("No step is made from a contact at the height of the bridge") {
    Orbit<Interval> orbit(Interval(1.5707), Interval(0), Interval(0.1));
    CHECK_FALSE(orbit.advance());
}
