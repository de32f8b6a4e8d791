#include "adiabatic/flight_leaf.hpp"

#include "catch.hpp"
#include "samples.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

namespace {

Verdict judged(const Interval& u, const Interval& sigma, double density) {
    const Potential<Interval> potential({{Interval(0.29), Interval(density)}});
    return judge_flights(u, sigma, Masses<Interval>(Interval(0.01)), Interval(0.3), Interval(1.2), potential);
}

}  // namespace

TEST_CASE("The angles admitted are those from the margin to pi/2, and none where there certainly is none") {
    const Interval margin(0.3, 0.31);
    const double quarter = half_pi<Interval>().hi();
    CHECK_FALSE(admitted_angle(Interval(1.5709, 2), margin));
    CHECK_FALSE(admitted_angle(Interval(0, 0.29), margin));
    const auto is = [&](const Interval& u, double lo, double hi) {
        const auto part = admitted_angle(u, margin);
        return part && part->lo() == lo && part->hi() == hi;
    };
    CHECK(is({0.5, 0.6}, 0.5, 0.6));
    CHECK(is({0, 2}, 0.3, quarter));
    CHECK(is({0.2, 0.305}, 0.3, 0.305));  // perhaps below the margin: kept
    CHECK(is({0, 0.3}, 0.3, 0.3));
    CHECK(is({half_pi<Interval>().lo(), 2}, half_pi<Interval>().lo(), quarter));
    CHECK(is({quarter, 2}, quarter, quarter));  // not certainly beyond pi/2
}

TEST_CASE(
    "Flights beyond the hypotheses are outside: past pi/2, too near the vertical, without a lower contact") {
    CHECK(judged({1.6, 1.7}, {0, 1}, 1).outside);
    CHECK(judged({0.1, 0.2}, {0, 1}, 1).outside);
    CHECK(judged({1.5, 1.51}, {7, 8}, 1).outside);
    CHECK_FALSE(judged({0.29, 0.31}, {0, 0.01}, 1).outside);
}

TEST_CASE("A greater density closes what a small one leaves open, and none closes nothing") {
    const Interval u(0.5, 0.501), sigma(0.5, 0.501);
    CHECK_FALSE(judged(u, sigma, 0).closed());
    CHECK_FALSE(judged(u, sigma, 1).closed());
    CHECK(judged(u, sigma, 1000).closed());
}

TEST_CASE("L35: where a box is closed, (D) holds for its flights") {
    Samples samples(5);
    int closed = 0;
    for (int i = 0; i < 2000; ++i) {
        const double density = samples.log_uniform(1, 1000);
        const Interval u = samples.around(samples.uniform(0.32, 1.5), 0.01);
        const Interval sigma = samples.around(samples.uniform(0.01, 2), 0.01);
        const Verdict verdict = judged(u, sigma, density);
        if (verdict.outside || !verdict.closed()) continue;
        const PointMasses m(0.01);
        const long double upper = half_turn / 2 - samples.in(u), k = samples.in(sigma)*std::sqrt(m.r);
        const long double height = std::sin(upper) - k * (half_turn / 2 + upper);
        if (height - k * half_turn / 2 <= 0) continue;
        const long double lower = root_below(height, -k, upper);
        const long double drift = h_at(lower, -k, m) - h_at(upper, k, m);
        CAPTURE(i, density, static_cast<double>(upper), static_cast<double>(k));
        CHECK(drift > -1e-17L);
        CHECK(drift <= m.r * density * (upper - lower) * std::sqrt(1 + k * k / m.r) + 1e-17L);
        ++closed;
    }
    CHECK(closed > 200);
}
