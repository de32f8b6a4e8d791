#include "flight/count.hpp"

#include <array>
#include <atomic>
#include <vector>

#include "catch.hpp"
#include "rays.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

constexpr long count_cap = 4000;

/// Fails unless upper >= true number >= lower, with equality where no decision was closer than `clear`.
/// Returns whether there was equality.
template <class I, class T>
bool check_counts(const DoubleRay& ray, double clear) {
    const auto exact = ray_count<T>(ray, count_cap);
    const long upper = as_long(count_at_most(as<I>(ray), count_cap));
    const long lower = as_long(count_at_least(as<I>(ray), count_cap));
    if (upper < exact.hits || lower > exact.hits) {
        FAIL(say(ray, "has", exact.hits, "collisions, bounds are", lower, upper));
    }
    if (exact.hits < count_cap && exact.margin > clear && (upper != exact.hits || lower != exact.hits)) {
        FAIL(say(ray, "has", exact.hits, "collisions with margin", exact.margin, "bounds are only", lower,
                 upper));
    }
    return upper == lower;
}

DoubleRay raised(Random& random, const DoubleRay& ray) {
    const auto some = [&](double most) { return random.coin() ? 0.0 : random.scaled(1e-16, most); };
    return {ray.c + some(1), ray.kappa + some(0.5), std::min(1.0, ray.r + some(0.5))};
}

}  // namespace

TEST_CASE("Both counts bound the true number of collisions, and meet away from grazing") {
    Random random(111);
    const long rays = scaled(4'000);
    int equal = 0;
    for (int i = 0; i < rays; ++i) {
        equal += check_counts<Interval, Real>(random_ray(random, 1e-3), 1e-9) ? 1 : 0;
    }
    CHECK(equal > rays * 17 / 20);
}

TEST_CASE("Grazing rays at margins of 1e-3 to 1e-17 on both sides are never miscounted") {
    Random random(112);
    for (int digits = 3; digits <= 17; ++digits) {
        for (int i = 0; i < 200; ++i) {
            const double r = random_r(random, 1e-3);
            const double margin = random.sign() * std::pow(10.0, -digits);
            check_counts<Interval, Real>(grazing_ray(random.uniform(-r, 0.95), margin, r), 1e-9);
        }
    }
}

TEST_CASE("Mass ratios of 1e4 to 1e6 with hundreds of collisions keep their enclosure") {
    Random random(113);
    for (const double r : {1e-4, 1e-5, 1e-6}) {
        for (int i = 0; i < 8; ++i) {
            const DoubleRay ray{r * random.uniform(0, 3), r * random.uniform(-1, 1.5), r};
            const auto exact = ray_count<Real>(ray, count_cap);
            const long upper = count_at_most(as<Interval>(ray), count_cap);
            const long lower = count_at_least(as<Interval>(ray), count_cap);
            CAPTURE(show(ray), exact.hits);
            CHECK(exact.hits > 40);
            CHECK(upper >= exact.hits);
            CHECK(lower <= exact.hits);
            CHECK(upper - lower <= 1);
        }
    }
}

TEST_CASE("In multiple precision, 53 to 512 bits, the counts bound and agree with the true number") {
    Random random(114);
    for (const int bits : {53, 90, 128, 256, 512}) {
        const PrecisionScope scope(bits);
        const double clear = std::max(1e-100, std::ldexp(1e6, -bits));
        for (int i = 0; i < 150; ++i) {
            const auto ray = random_ray(random, 1e-2);
            check_counts<BigInterval, Decimal<200>>(ray, std::max(clear, 1e-9));
        }
    }
}

TEST_CASE("With 6 to 40 bits, where rounding to the wrong side shows, the counts still are bounds") {
    Random random(117);
    for (int i = 0; i < 6'000; ++i) {
        const PrecisionScope scope(6 + random.below(35));
        check_counts<BigInterval, Real>(random_ray(random, 1e-2), infinity);
    }
}

TEST_CASE("More bits decide rays that graze too closely for doubles") {
    const PrecisionScope scope(256);
    Random random(115);
    int undecided_in_double = 0;
    for (int i = 0; i < 300; ++i) {
        const auto ray = grazing_ray(random.uniform(0, 0.9), random.sign() * 1e-16, 0.01);
        undecided_in_double +=
            count_at_most(as<Interval>(ray), count_cap) != count_at_least(as<Interval>(ray), count_cap) ? 1
                                                                                                        : 0;
        if (!check_counts<BigInterval, Real>(ray, 1e-30)) {
            FAIL(say("undecided with 256 bits:", ray));
        }
    }
    CHECK(undecided_in_double > 100);
}

TEST_CASE("The upper count holds for every ray above, the lower count for every ray below") {
    Random random(116);
    for (int i = 0; i < scaled(2'000); ++i) {
        const DoubleRay low = random_ray(random, 1e-3);
        const DoubleRay high = raised(random, low);
        const long upper = count_at_most(as<Interval>(low), count_cap);
        const long lower = count_at_least(as<Interval>(high), count_cap);
        if (ray_count<Real>(high, count_cap).hits > upper || ray_count<Real>(low, count_cap).hits < lower) {
            FAIL(say("from", low, "to", high, "bounds", lower, upper));
        }
        if (lower > upper) {
            FAIL(say("bounds crossed from", low, "to", high));
        }
    }
}

TEST_CASE("Of a ray that is wide in one of c, kappa and r, or in all, one end counts, from either side") {
    const DoubleRay low{0.01, 0, 0.01};
    for (const int which : {0, 1, 2, 3}) {
        CAPTURE(which);
        const auto end = [&](int axis, double from, double to) {
            return which == axis || which == 3 ? to : from;
        };
        const DoubleRay high{end(0, low.c, 0.9), end(1, low.kappa, 0.4), end(2, low.r, 0.2)};
        const Ray<Interval> wide{Interval(low.c, high.c), Interval(low.kappa, high.kappa),
                                 Interval(low.r, high.r)};
        const long most = ray_count<Real>(low).hits, fewest = ray_count<Real>(high).hits;
        REQUIRE(fewest < most);
        CHECK(count_at_most(wide, count_cap) == most);
        CHECK(count_at_least(wide, count_cap) == fewest);
    }
}

TEST_CASE("A lower count never exceeds its cap, also where the next collision is the last") {
    CHECK(count_at_least(as<Interval>({0.9999, 0, 0.1}), 0) == 0);
    CHECK(count_at_least(as<Interval>({0.9999, 0, 0.1}), 1) == 1);
}

TEST_CASE("The counts stop at their cap") {
    const auto ray = as<Interval>({1e-6, 1e-6, 1e-4});
    const long all = ray_count<Real>(DoubleRay{1e-6, 1e-6, 1e-4}).hits;
    REQUIRE(all > 20);
    CHECK(count_at_most(ray, 10) == 11);
    CHECK(count_at_most(ray, all) == all);
    CHECK(count_at_most(ray, all - 1) == all);
    CHECK(count_at_most(ray, 0) == 1);
    CHECK(count_at_least(ray, 10) == 10);
    CHECK(count_at_least(ray, 0) == 0);
    CHECK(count_at_least(ray, all + 5) == all);
}

TEST_CASE("What is seen on the way are the flights, each with bounds that the rest is counted from") {
    const auto ray = as<Interval>({1e-4, 5e-5, 1e-4});
    const long all = count_at_most(ray, count_cap);
    REQUIRE(all > 10);
    long flights = 0;
    CHECK(count_at_most(ray, count_cap, never, [&](long n, const Interval& c, const Interval& kappa) {
              CHECK(n == flights++);
              CHECK(n + count_at_most(Ray<Interval>{c, kappa, ray.r}, count_cap) == all);
              CHECK(n + count_at_least(Ray<Interval>{c, kappa, ray.r}, count_cap) == all);
          }) == all);
    CHECK(flights == all + 1);
}

namespace {

/// What is seen on the way of an upper count.
template <class I>
long looks(const Ray<I>& ray, const CountOf<I>& cap) {
    long seen = 0;
    (void)count_at_most(ray, cap, never, [&](const auto&, const auto&, const auto&) { ++seen; });
    return seen;
}

}  // namespace

TEMPLATE_TEST_CASE("4 10^11 collisions are counted to the last one, of which a few hundred are seen", "",
                   Interval, BigInterval) {
    using I = TestType;
    constexpr long cap = 1'000'000'000'000'000;
    const auto ray = as<I>({1e-24, 1e-24, 1e-24});
    const CountOf<I> most = count_at_most(ray, CountOf<I>(cap));
    CHECK(most == count_at_least(ray, CountOf<I>(cap)));
    CHECK(static_cast<double>(most) == Approx(0.442798e12));
    CHECK(looks(ray, CountOf<I>(cap)) < 300);
    for (const long less : {100'000L, 100'000'000L}) {
        CHECK(count_at_most(ray, CountOf<I>(less)) == less + 1);
        CHECK(count_at_least(ray, CountOf<I>(less)) == less);
        CHECK(looks(ray, CountOf<I>(less)) < 50);
    }
    for (int n = 0; n < 30; n += 3) {
        int left = n;
        CHECK(count_at_most(ray, CountOf<I>(cap), [&] { return left-- <= 0; }) == cap + 1);
        left = n;
        CHECK(count_at_least(ray, CountOf<I>(cap), [&] { return left-- <= 0; }) < most);
    }
}

TEST_CASE("Where double is too coarse for macro steps an upper count gives up") {
    const auto ray = as<Interval>({1e-32, 1e-32, 1e-32});
    constexpr long cap = 1'000'000'000'000'000'000;
    CHECK(count_at_most(ray, cap) == cap + 1);
    CHECK(count_at_least(ray, cap) > 4'000'000'000'000'000);
}

TEST_CASE("Rays that are too steep or too high never collide") {
    for (const DoubleRay& ray :
         {DoubleRay{0, 1, 0.1}, DoubleRay{0.5, 2, 1}, DoubleRay{1.5, 0, 0.5}, DoubleRay{1e9, 0.5, 1e-3}}) {
        CAPTURE(show(ray));
        CHECK(count_at_most(as<Interval>(ray), count_cap) == 0);
        CHECK(count_at_least(as<Interval>(ray), count_cap) == 0);
    }
}

TEMPLATE_TEST_CASE("NaN never gives a small upper count, nor a positive lower one", "", Interval,
                   BigInterval) {
    using I = TestType;
    const I bad(not_a_number);
    for (int which = 1; which < 8; ++which) {
        const Ray<I> ray{which & 1 ? bad : I(0.01), which & 2 ? bad : I(0.01), which & 4 ? bad : I(0.01)};
        CAPTURE(which);
        CHECK(count_at_most(ray, 5) == 6);
        CHECK(count_at_least(ray, 5) <= 1);  // the first collision does not depend on r
        CHECK((which == 4 || count_at_least(ray, 5) == 0));
    }
}

TEST_CASE("Of several counts each is done once, and in double one after the other") {
    std::vector<std::size_t> order;
    each_count<Interval>(5, [&](std::size_t i) { order.push_back(i); });
    CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
    std::array<std::atomic<int>, 5> times{};
    each_count<BigInterval>(times.size(), [&](std::size_t i) { ++times[i]; });
    for (const auto& n : times) {
        CHECK(n == 1);
    }
}
