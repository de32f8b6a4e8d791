#include "flight/extremal_orbit.hpp"

#include "attacks/oracle/extremal.hpp"
#include "catch.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

using Digits = dumbbell_oracle::Digits80;
using Flights = std::vector<dumbbell_oracle::Ray<Digits>>;

// The flights of the oracle: those that collide, and the last one if it exists.
Flights exact_flights(ExtremalOrbit orbit, const Digits& r) {
    return dumbbell_oracle::flights(
        orbit == ExtremalOrbit::top ? dumbbell_oracle::top_ray(r) : dumbbell_oracle::corner_ray(r), r);
}

template <class I>
std::vector<MovingRay<I>> enclosed_flights(ExtremalOrbit orbit, const I& r) {
    std::vector<MovingRay<I>> all{first_moving_ray(orbit, r)};
    while (auto next = after_collision(all.back())) {
        all.push_back(std::move(*next));
    }
    return all;
}

constexpr std::array both{ExtremalOrbit::top, ExtremalOrbit::corner};

// `v` up to the rounding of differences in 80 digits.
template <class I>
bool nearly_encloses(const I& x, const Digits& v) {
    const Digits rounding = 1e-50;
    return low_at_most(x, Digits(v + rounding)) && high_at_least(x, Digits(v - rounding));
}

// At every r the enclosures hold the recomputed flights, and between any two of them the quotient of
// differences is in the enclosure of the derivative (mean value theorem).
template <class I>
void check_range(ExtremalOrbit orbit, const I& range, const std::vector<Digits>& at) {
    const auto enclosed = enclosed_flights(orbit, range);
    std::vector<Flights> exact;
    for (const Digits& r : at) {
        exact.push_back(exact_flights(orbit, r));
        REQUIRE(enclosed.size() <= exact.back().size());
    }
    for (std::size_t j = 0; j < enclosed.size(); ++j) {
        const auto& [c, kappa, r] = enclosed[j].ray;
        const auto m = margin(enclosed[j].ray), m_rate = margin_rate(enclosed[j]);
        const auto& rate = enclosed[j].rate;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const auto& one = exact[i][j];
            INFO("flight " << j << " at " << at[i]);
            REQUIRE(encloses(c, one.c));
            REQUIRE(encloses(kappa, one.kappa));
            REQUIRE(encloses(m, greatest_excess(one)));
            if (i == 0) {
                continue;
            }
            const auto& other = exact[i - 1][j];
            const Digits change = at[i] - at[i - 1];
            REQUIRE(nearly_encloses(rate[0], Digits((one.c - other.c) / change)));
            REQUIRE(nearly_encloses(rate[1], Digits((one.kappa - other.kappa) / change)));
            REQUIRE(
                nearly_encloses(m_rate, Digits((greatest_excess(one) - greatest_excess(other)) / change)));
        }
    }
}

}  // namespace

TEST_CASE("theorem 2: which flight of which orbit is tangent at a critical ratio") {
    const auto is = [](long n, ExtremalOrbit orbit, long flight) {
        return tangent_flight(n).orbit == orbit && tangent_flight(n).flight == flight;
    };
    CHECK(is(3, ExtremalOrbit::top, 1));
    CHECK(is(4, ExtremalOrbit::corner, 1));
    CHECK(is(5, ExtremalOrbit::top, 2));
    CHECK(is(12, ExtremalOrbit::corner, 5));
    CHECK(is(901, ExtremalOrbit::top, 450));
}

TEST_CASE(
    "Enclosed flights of both orbits hold the recomputed ones at every r of a range, and their slopes") {
    Random random(151);
    for (int i = 0; i < 12; ++i) {
        const double r = 1 / random.scaled(1.5, 3e3);
        const double half = r * random.scaled(1e-14, 1e-4);
        std::vector<Digits> at{Digits(r - half), Digits(r), Digits(r + half / 3), Digits(r + half)};
        for (const ExtremalOrbit orbit : both) {
            check_range(orbit, Interval(r - half, r + half), at);
            const PrecisionScope scope(60 + random.below(200));
            check_range(orbit, BigInterval(r - half, r + half), at);
        }
    }
}

TEST_CASE("At a single r every flight is found, up to the one that misses") {
    Random random(152);
    const PrecisionScope scope(128);
    for (int i = 0; i < 10; ++i) {
        const double r = 1 / random.scaled(1.5, 3e3);
        for (const ExtremalOrbit orbit : both) {
            CAPTURE(r);
            const auto enclosed = enclosed_flights(orbit, BigInterval(r));
            const auto exact = exact_flights(orbit, Digits(r));
            REQUIRE(enclosed.size() == exact.size());
            // The last one is not certain to collide, all others are.
            CHECK_FALSE(certainly_positive(margin(enclosed.back().ray)));
            for (std::size_t j = 0; j + 1 < enclosed.size(); ++j) {
                REQUIRE(certainly_positive(margin(enclosed[j].ray)));
            }
        }
    }
}

TEST_CASE("L27: the enclosed rates are at least those of the lemma") {
    const PrecisionScope scope(128);
    const double pi_below = 3.14159;
    for (const double q : {2.0, 30.0, 1000.0}) {
        for (const ExtremalOrbit orbit : both) {
            const auto flights = enclosed_flights(orbit, BigInterval(1 / q));
            for (std::size_t j = 0; j < flights.size(); ++j) {
                const auto n = static_cast<double>(j);
                const bool top = orbit == ExtremalOrbit::top;
                const double bound = top ? 1 + pi_below * n * (n + 1) : pi_below * (n + 1) * (n + 1);
                CAPTURE(q, j);
                CHECK(flights[j].rate[0].lo() >= bound * (1 - 1e-12));
                CHECK(flights[j].rate[1].lo() >= (top ? 2 * n : 2 * n + 1) * (1 - 1e-12));
                CHECK(margin_rate(flights[j]).hi() <= -bound * (1 - 1e-12));
            }
        }
    }
}

TEST_CASE("theorem 2: the margin of the tangent flight changes its sign at the critical ratio") {
    // q_c(5) = 11.36225...: the second flight of the top orbit.
    const PrecisionScope scope(128);
    const auto margin_over = [](double q_lo, double q_hi) {
        const auto flights = enclosed_flights(ExtremalOrbit::top, BigInterval(1 / q_hi, 1 / q_lo));
        REQUIRE(flights.size() == 2);
        return margin(flights[1].ray);
    };
    CHECK(certainly_positive(margin_over(11.3623, 11.37)));
    CHECK(certainly_positive(-margin_over(11.35, 11.3622)));
    const BigInterval both_sides = margin_over(11.35, 11.37);
    CHECK((both_sides.lo() < 0 && both_sides.hi() > 0));
}

TEST_CASE("Enclosures stay narrow over hundreds of flights") {
    const PrecisionScope scope(128);
    const auto thin = enclosed_flights(ExtremalOrbit::corner, BigInterval(0x1p-18));
    REQUIRE(thin.size() > 200);
    CHECK(width(thin[200].ray.c) < 0x1p-105);
    const auto range = enclosed_flights(ExtremalOrbit::corner, BigInterval(0x1p-18, 0x1p-18 + 0x1p-70));
    const auto& last = range[200];
    CHECK(width(last.ray.c) < 1.001 * 0x1p-70 * last.rate[0].hi());
    CHECK(width(last.rate[0]) < 1e-9 * last.rate[0].lo());
}

TEST_CASE("Equal masses: the top orbit is tangent at once, exactly") {
    const auto flight = first_moving_ray(ExtremalOrbit::top, BigInterval(1));
    const auto m = margin(flight.ray), rate = margin_rate(flight);
    CHECK((m.lo() == 0 && m.hi() == 0));
    CHECK((rate.lo() == -1 && rate.hi() == -1));
    CHECK_FALSE(after_collision(flight));
}

TEST_CASE("A ray that is not a number has no next flight") {
    CHECK_FALSE(after_collision(first_moving_ray(ExtremalOrbit::top, Interval(not_a_number))));
    CHECK_FALSE(after_collision(first_moving_ray(ExtremalOrbit::corner, BigInterval(not_a_number))));
}
