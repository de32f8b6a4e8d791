#include "adiabatic/drift.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

namespace {

struct Flown {
    Interval upper, sigma, delta;
};

Flown draw(Samples& samples, double width) {
    return {samples.around(samples.uniform(0.2, 1.35), width),
            samples.around(samples.uniform(0.01, 2), width),
            samples.around(samples.log_uniform(1e-3, 0.08), width)};
}

/// One flight of a box; only those that have a lower contact, and come from below at the upper one.
struct Flight {
    PointMasses m;
    long double upper, sigma, k, height;
    bool real;

    Flight(Samples& samples, const Flown& box)
        : m(samples.in(box.delta)), upper(samples.in(box.upper)), sigma(samples.in(box.sigma)) {
        k = sigma * std::sqrt(m.r);
        height = std::sin(upper) - k * (half_turn / 2 + upper);
        real = height - k * half_turn / 2 > 0 && k < std::cos(upper);
    }
};

}  // namespace

TEST_CASE("L34: the roots X(lambda) lie between their bounds, over boxes of flights") {
    Samples samples(3);
    int tried = 0;
    for (int i = 0; i < 3000; ++i) {
        const Flown box = draw(samples, samples.log_uniform(1e-12, 0.1));
        const LightFlights<Interval> flights(box.upper, box.sigma, Masses<Interval>(box.delta));
        const Flight flight(samples, box);
        if (!flight.real) continue;
        for (const double lambda : {-1.0, -0.5, 0.0, 0.75, 1.0}) {
            const long double root = root_below(flight.height, lambda * flight.k, flight.upper);
            CAPTURE(i, lambda, static_cast<double>(root));
            CHECK(flights.least_root(Interval(lambda)).lo() <= root + 1e-14L);
            CHECK(flights.greatest_root(Interval(lambda)).hi() >= root - 1e-14L);
        }
        ++tried;
    }
    CHECK(tried > 500);
}

TEST_CASE("L34, L35: the sums over the parts enclose the drift, and the growth of the potential from below") {
    Samples samples(4);
    int tried = 0;
    for (int i = 0; i < 1500; ++i) {
        const Flown box = draw(samples, samples.log_uniform(1e-12, 0.01));
        const LightFlights<Interval> flights(box.upper, box.sigma, Masses<Interval>(box.delta));
        const Flight flight(samples, box);
        if (!flight.real) continue;
        const auto sums = drift_sums(flights, [](const Interval&) { return Interval(1); });
        if (!sums) continue;
        const long double lower = root_below(flight.height, -flight.k, flight.upper);
        const long double drift = h_at(lower, -flight.k, flight.m) - h_at(flight.upper, flight.k, flight.m);
        const long double unit = flight.k * flight.m.r;
        CAPTURE(i, static_cast<double>(drift / unit), sums->drift.lo(), sums->drift.hi());
        // The difference loses what its two sides cancel.
        const long double lost = 1e-17L / unit;
        CHECK(sums->drift.lo() <= drift / unit + lost);
        CHECK(sums->drift.hi() >= drift / unit - lost);
        const long double growth =
            (flight.upper - lower) / flight.k * std::sqrt(1 + flight.sigma * flight.sigma);
        CHECK(sums->growth.lo() <= growth * (1 + 1e-12L) + 1e-17L / flight.k);
        ++tried;
    }
    CHECK(tried > 300);
}

TEST_CASE("The parts divide [-1, 1] exactly") {
    CHECK(drift_part_end(0) == -1);
    CHECK(drift_part_end(drift_parts) == 1);
    for (int i = 0; i < drift_parts; ++i) {
        CHECK(drift_part_end(i) < drift_part_end(i + 1));
    }
}
