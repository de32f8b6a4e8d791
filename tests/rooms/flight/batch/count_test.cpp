#include "flight/batch/count.hpp"

#include <cfenv>

#include "base/error.hpp"
#include "catch.hpp"
#include "flight/count.hpp"
#include "rooms/flight/rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;
using batch::Answer;
using batch::Backend;
using batch::Query;

namespace {

constexpr long cap = 4000;

Query query(const DoubleRay& ray, long most = cap) { return {{ray.c, ray.kappa, ray.r}, most}; }

std::vector<Answer> answers(const std::vector<Query>& queries, Backend backend) {
    std::vector<Answer> result(queries.size());
    batch::count_at_most(queries, result, backend);
    return result;
}
Answer answer(const Query& one, Backend backend) { return answers({one}, backend).front(); }

std::vector<Answer> fewest(const std::vector<Query>& queries, Backend backend) {
    std::vector<Answer> result(queries.size());
    batch::count_at_least(queries, result, backend);
    return result;
}
long fewest(const Query& one, Backend backend) { return fewest(std::vector{one}, backend).front().count; }

std::vector<Query> random_queries(Random& random, int n, double least_r) {
    std::vector<Query> queries;
    for (int i = 0; i < n; ++i) {
        queries.push_back(query(random_ray(random, least_r), random.coin() ? cap : random.below(6)));
    }
    return queries;
}

/// A ray of any doubles, NaN and infinities included.
Query wild(Random& random) {
    const auto some = [&] {
        const int which = random.below(12);
        return which == 0   ? not_a_number
               : which == 1 ? random.sign() * infinity
               : which < 5  ? adversarial(random)
                            : random.uniform(-1.2, 1.2);
    };
    return {{some(), some(), random.coin() ? random_r(random) : some()}, random.below(8) - 1};
}

void check_same(const std::vector<Query>& queries) {
    const auto most = answers(queries, Backend::portable);
    const auto lower = fewest(queries, Backend::portable);
    for (const Backend backend : batch::backends()) {
        const auto other_most = answers(queries, backend);
        const auto other_fewest = fewest(queries, backend);
        const auto same = [](const Answer& a, const Answer& b) {
            return a.count == b.count && a.clear == b.clear;
        };
        for (std::size_t i = 0; i < queries.size(); ++i) {
            if (!same(other_most[i], most[i]) || !same(other_fewest[i], lower[i])) {
                const auto& ray = queries[i].ray;
                FAIL(say(std::string(batch::name(backend)), "says", other_fewest[i].count,
                         other_most[i].count, "and plain", lower[i].count, most[i].count, "of c", ray.c,
                         "kappa", ray.kappa, "r", ray.r));
            }
        }
    }
}

/// Fails unless upper >= true number >= lower, with equality where no decision was closer than 1e-9.
void check_bounds(const DoubleRay& ray) {
    const auto exact = ray_count<Real>(ray, cap);
    const long upper = answer(query(ray), Backend::portable).count;
    const long lower = fewest(query(ray), Backend::portable);
    if (upper < exact.hits || lower > exact.hits) {
        FAIL(say(ray, "has", exact.hits, "collisions, bounds are", lower, upper));
    }
    if (exact.hits < cap && exact.margin > 1e-9 && (upper != exact.hits || lower != exact.hits)) {
        FAIL(say(ray, "has", exact.hits, "collisions with margin", exact.margin, "bounds are only", lower,
                 upper));
    }
}

}  // namespace

TEST_CASE("Every backend of this machine gives the same answers to 100,000 rays of all kinds") {
    Random random(421);
    check_same(random_queries(random, 100'000, 1e-3));
}

TEST_CASE("The same for rays that graze at 1e-3 to 1e-17, and for any doubles") {
    Random random(422);
    std::vector<Query> queries;
    for (int i = 0; i < 40'000; ++i) {
        const double r = random_r(random, 1e-3);
        queries.push_back(
            query(grazing_ray(random.uniform(-r, 0.99), random.sign() * random.scaled(1e-17, 1e-3), r)));
        queries.push_back(wild(random));
    }
    check_same(queries);
}

TEST_CASE("An answer depends neither on the other rays of the queue nor on their order") {
    Random random(423);
    const auto queries = random_queries(random, 500, 1e-3);
    const std::vector<Query> reversed(queries.rbegin(), queries.rend());
    for (const Backend backend : batch::backends()) {
        const auto together = answers(queries, backend);
        const auto backwards = answers(reversed, backend);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const Answer alone = answer(queries[i], backend);
            CHECK(alone.count == together[i].count);
            CHECK(alone.clear == together[i].clear);
            CHECK(alone.count == backwards[queries.size() - 1 - i].count);
        }
    }
}

TEST_CASE("Both counts bound the true number of collisions for 20,000 rays, and meet away from grazing") {
    Random random(424);
    for (int i = 0; i < 20'000; ++i) {
        check_bounds(random_ray(random, 1e-3));
    }
}

TEST_CASE("Grazing rays at margins of 1e-3 to 1e-17 on both sides are never miscounted") {
    Random random(425);
    for (int digits = 3; digits <= 17; ++digits) {
        for (int i = 0; i < 400; ++i) {
            const double r = random_r(random, 1e-3);
            check_bounds(grazing_ray(random.uniform(-r, 0.95), random.sign() * std::pow(10.0, -digits), r));
        }
    }
}

TEST_CASE("The bounds of 200 bits lie between them, also for small ratios and up to small caps") {
    const PrecisionScope scope(200);
    Random random(426);
    for (int i = 0; i < 6'000; ++i) {
        const Query one = query(random_ray(random, 1e-4), random.coin() ? cap : random.below(5));
        const DoubleRay ray{one.ray.c, one.ray.kappa, one.ray.r};
        const long big_most = as_long(count_at_most(as<BigInterval>(ray), one.cap));
        const long big_least = as_long(count_at_least(as<BigInterval>(ray), one.cap));
        const long upper = answer(one, Backend::portable).count;
        const long lower = fewest(one, Backend::portable);
        if (upper < big_most || lower > big_least) {
            FAIL(say(ray, "cap", one.cap, "bounds", lower, upper, "in 200 bits", big_least, big_most));
        }
    }
}

TEST_CASE("What is not certain although all was clear is not certain for Interval either") {
    Random random(427);
    int clear = 0;
    for (int i = 0; i < 30'000; ++i) {
        const Query one = query(random_ray(random, 1e-3), random.below(12));
        const Answer found = answer(one, Backend::portable);
        if (found.count > one.cap && found.clear) {
            ++clear;
            CHECK(count_at_most(
                      Ray<Interval>{Interval(one.ray.c), Interval(one.ray.kappa), Interval(one.ray.r)},
                      one.cap) > one.cap);
        }
    }
    CHECK(clear > 1'000);
}

TEST_CASE("The upper count holds for every ray above, the lower count for every ray below") {
    Random random(428);
    for (int i = 0; i < 6'000; ++i) {
        const DoubleRay low = random_ray(random, 1e-3);
        const auto some = [&](double most) { return random.coin() ? 0.0 : random.scaled(1e-16, most); };
        const DoubleRay high{low.c + some(1), low.kappa + some(0.5), std::min(1.0, low.r + some(0.5))};
        const long upper = answer(query(low), Backend::portable).count;
        const long lower = fewest(query(high), Backend::portable);
        if (ray_count<Real>(high, cap).hits > upper || ray_count<Real>(low, cap).hits < lower) {
            FAIL(say("from", low, "to", high, "bounds", lower, upper));
        }
    }
}

TEST_CASE("Mass ratios of 1e4 to 1e6 with hundreds of collisions are counted to one") {
    Random random(429);
    for (const double r : {1e-4, 1e-5, 1e-6}) {
        for (int i = 0; i < 8; ++i) {
            const DoubleRay ray{r * random.uniform(0, 3), r * random.uniform(-1, 1.5), r};
            const auto exact = ray_count<Real>(ray, cap);
            const Answer found = answer(query(ray), Backend::portable);
            CAPTURE(show(ray), exact.hits);
            CHECK(exact.hits > 40);
            CHECK(found.count >= exact.hits);
            CHECK(found.count <= exact.hits + 1);
            CHECK(fewest(query(ray), Backend::portable) <= exact.hits);
            CHECK(fewest(query(ray), Backend::portable) >= exact.hits - 1);
        }
    }
}

TEST_CASE("The counts stop at their cap") {
    const DoubleRay ray{1e-6, 1e-6, 1e-4};
    const long all = ray_count<Real>(ray).hits;
    REQUIRE(all > 20);
    for (const Backend backend : batch::backends()) {
        CHECK(answer(query(ray, 10), backend).count == 11);
        CHECK(answer(query(ray, all), backend).count == all);
        CHECK(answer(query(ray, all - 1), backend).count == all);
        CHECK(answer(query(ray, 0), backend).count == 1);
        CHECK(fewest(query(ray, 10), backend) == 10);
        CHECK(fewest(query(ray, 0), backend) == 0);
        CHECK(fewest(query(ray, all + 5), backend) == all);
    }
}

TEST_CASE(
    "Rays that are too steep or too high never collide, and bounds below the domain are taken as its edge") {
    for (const DoubleRay& ray : {DoubleRay{0, 1, 0.1}, {0.5, 2, 1}, {1.5, 0, 0.5}, {1e9, 0.5, 1e-3}}) {
        CAPTURE(show(ray));
        CHECK(answer(query(ray), Backend::portable).count == 0);
        CHECK(fewest(query(ray), Backend::portable) == 0);
    }
    const auto low = answer(query({-1e-300, -5, 0.1}), Backend::portable);
    CHECK(low.count == answer(query({0, -1, 0.1}), Backend::portable).count);
}

TEST_CASE("NaN never gives a small upper count, nor a positive lower one, nor does a ratio that is none") {
    for (const Backend backend : batch::backends()) {
        for (int which = 1; which < 8; ++which) {
            const auto part = [&](int bit) { return (which & bit) != 0 ? not_a_number : 0.01; };
            CAPTURE(which);
            const Query bad{{part(1), part(2), part(4)}, 5};
            CHECK(answer(bad, backend).count == 6);
            CHECK(fewest(bad, backend) <= (which == 4 ? 1 : 0));  // the first collision does not depend on r
        }
        for (const double r : {0.0, -0.1, 1.5, infinity, -infinity}) {
            CHECK(answer({{0.01, 0.01, r}, 5}, backend).count == 6);
            CHECK(answer({{0.01, 0.9, r}, 5}, backend).count == 6);
        }
        CHECK(answer({{infinity, 0.01, 0.1}, 5}, backend).count == 6);
    }
}

TEST_CASE("A thread that does not round to nearest gets no answer") {
    std::vector<Answer> found(1);
    const std::vector<Query> queries{query({0.1, 0, 0.1})};
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        CHECK_THROWS_AS(batch::count_at_most(queries, found, Backend::portable), BrokenInvariant);
        CHECK_THROWS_AS(batch::count_at_least(queries, found, Backend::portable), BrokenInvariant);
        std::fesetround(FE_TONEAREST);
    }
}

TEST_CASE("A cap that doubles cannot tell from the next number is refused") {
    const DoubleRay ray{0.5, 0.9, 0.1};
    for (const Backend backend : batch::backends()) {
        CHECK(answer(query(ray, batch::greatest_cap), backend).count <= 1);
        CHECK_THROWS_AS(answer(query(ray, batch::greatest_cap + 1), backend), BrokenInvariant);
        CHECK_THROWS_AS(fewest(query(ray, batch::greatest_cap + 1), backend), BrokenInvariant);
        CHECK(answer({{not_a_number, 0, 0.1}, batch::greatest_cap}, backend).count > batch::greatest_cap);
    }
}

TEST_CASE("No queries, no answers") {
    for (const Backend backend : batch::backends()) {
        CHECK(answers({}, backend).empty());
    }
}

TEST_CASE("What an interruption cuts off is not certain") {
    const std::vector<Query> queries(20, query({0, 0, 1e-13}, 100'000'000));
    for (const Backend backend : batch::backends()) {
        std::vector<Answer> found(queries.size());
        batch::count_at_most(queries, found, backend, [] { return true; });
        for (const Answer& one : found) {
            CHECK(one.count == 100'000'001);
            CHECK_FALSE(one.clear);
        }
        batch::count_at_least(queries, found, backend, [] { return true; });
        for (const Answer& one : found) {
            CHECK(one.count == 0);
        }
    }
}
