#include "adiabatic/potential.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

using Density = adiabatic::Potential<Interval>;

Density three_cells() {
    return Density(
        {{Interval(1.0), Interval(2.0)}, {Interval(0.5), Interval(8.0)}, {Interval(0.25), Interval(4.0)}});
}

}  // namespace

TEST_CASE("The least density is that of all cells that an interval meets, at their ends too") {
    const Density potential = three_cells();
    const auto density = [&](double lo, double hi) { return potential.least_density(Interval(lo, hi)).lo(); };
    CHECK(density(1.1, 1.5) == 2);
    CHECK(density(0.6, 0.9) == 8);
    CHECK(density(0.6, 1.1) == 2);
    CHECK(density(0.5, 0.6) == 4);  // the cells are closed
    CHECK(density(0.6, 1.0) == 2);
    CHECK(density(0.25, 0.3) == 4);
    CHECK(density(0.3, 1.5) == 2);
}

TEST_CASE("Below the last cell there is no density") {
    const Density potential = three_cells();
    CHECK(potential.least_density(Interval(0.24, 0.3)).lo() == 0);
    CHECK(potential.least_density(Interval(0.1, 0.2)).lo() == 0);
}

TEST_CASE("The potential is the integral of the density from the angle to pi/2, bounded from above") {
    const Density potential = three_cells();
    const auto value = [&](double u) { return potential.greatest_value(Interval(u)).hi(); };
    CHECK(value(1.0) == Approx(2 * (11.0 / 7 - 1)));
    CHECK(value(0.75) == Approx(2 * (11.0 / 7 - 1) + 8 * 0.25));
    CHECK(value(0.25) == Approx(2 * (11.0 / 7 - 1) + 4 + 1));
    CHECK(value(0.1) == value(0.25));
    CHECK(potential.greatest_value(Interval(0.75, 1.5)).hi() >= value(0.75));
    CHECK(value(1.0) >= 2 * (3.14159265358979 / 2 - 1));
}
