// proofs/theorem.md, L26-L29 and Theorem 2: how the extremal orbits move with the ratio, and the critical
// ratios.
#include <algorithm>

#include "catch.hpp"
#include "extremal.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

const Digits80 turn_half = pi<Digits80>();

struct Bounds {  // least derivatives of kappa_j and c_j by r (L27)
    Digits80 kappa;
    Digits80 c;
};
Bounds top_bounds(std::size_t j) { return {Digits80(2 * j), Digits80(1 + turn_half * j * (j + 1))}; }
Bounds corner_bounds(std::size_t j) { return {Digits80(2 * j + 1), Digits80(turn_half * (j + 1) * (j + 1))}; }

}  // namespace

TEST_CASE("L26: the orbits of the corner and of the top are interlaced, flight by flight") {
    Sampler sampler(1, 811);
    for (int i = 0; i < scaled(400); ++i) {
        const double ratio = random_ratio(sampler, 1e3);
        const Digits80 r = 1 / Digits80(ratio);
        const auto top = flights(top_ray(r), r);
        const auto corner = flights(corner_ray(r), r);
        const auto below = [](const Ray<Digits80>& a, const Ray<Digits80>& b) {
            return a.c < b.c && a.kappa < b.kappa;
        };
        bool ok = top.size() >= corner.size() && top.size() <= corner.size() + 1;
        for (std::size_t j = 0; ok && j < corner.size(); ++j) {
            ok = below(top[j], corner[j]) && (j + 1 >= top.size() || below(corner[j], top[j + 1]));
        }
        if (!ok) FAIL(say("q", ratio, top.size(), corner.size()));
    }
    SUCCEED();
}

TEST_CASE("L27: slopes and heights of the extremal orbits grow with r, at least as fast as stated") {
    Sampler sampler(1, 812);
    const Digits80 change = 1e-30;
    const long ratios = scaled(150);
    int compared = 0;
    Digits80 tightest = 1e9;
    for (int i = 0; i < ratios; ++i) {
        const double ratio = sampler.coin() ? random_ratio(sampler, 1e3) : sampler.log_uniform(1e3, 1e9);
        const Digits80 r = 1 / Digits80(ratio);
        const Digits80 r_less = r * (1 - change);
        for (const bool at_top : {true, false}) {
            auto ray = at_top ? top_ray(r) : corner_ray(r);
            auto less = at_top ? top_ray(r_less) : corner_ray(r_less);
            for (std::size_t j = 0; j < 40; ++j) {
                const Bounds least = at_top ? top_bounds(j) : corner_bounds(j);
                const Digits80 kappa_rate = (ray.kappa - less.kappa) / (r - r_less);
                const Digits80 c_rate = (ray.c - less.c) / (r - r_less);
                const Digits80 margin_rate = (greatest_excess(ray) - greatest_excess(less)) / (r - r_less);
                const Digits80 near = 1 - Digits80(1e-20);
                const bool ok = kappa_rate >= least.kappa * near && c_rate >= least.c * near &&
                                margin_rate <= -least.c * near && ray.kappa >= least.kappa * r * near &&
                                ray.c >= least.c * r * near;
                if (!ok) FAIL(say("q", ratio, at_top, "flight", j, kappa_rate, c_rate, margin_rate));
                ++compared;
                if (j > 0) tightest = std::min(tightest, Digits80(c_rate / least.c));
                const auto next = step(ray, r);
                const auto next_less = step(less, r_less);
                if (!next || !next->next) break;
                if (!next_less || !next_less->next) FAIL(say("q", ratio, "the lower ray ends first"));
                ray = *next->next;
                less = *next_less->next;
            }
        }
    }
    CHECK(compared > 5 * ratios);
    CHECK(tightest < 1.01);  // for large q the bounds are sharp
}

TEST_CASE("L28: a flight at height pi kappa or more over the corner collides only if it is flat") {
    Sampler sampler(1, 813);
    const Real limit = 1 / std::sqrt(1 + pi<Real>() * pi<Real>());
    Real steepest = 0;
    for (int i = 0; i < scaled(100'000); ++i) {
        const Real kappa = biased(sampler, 0, 1);
        const Real c = pi<Real>() * kappa + (sampler.coin() ? 0 : sampler.log_uniform(1e-9, 1));
        if (hit_place(Ray<Real>{c, kappa})) steepest = std::max(steepest, kappa);
    }
    CHECK(steepest < limit);
    CHECK(steepest > 0.6L * limit);
    // Flights that come from the bridge can be steeper.
    CHECK(hit_place(bridge_ray(BridgeState<Real>{pi<Real>() / 2, 320}, Real(1e-3L))));
    CHECK(limit < 0.32L);
}

TEST_CASE("L29, theorem 2: at its critical ratio each orbit ends in a tangency, and N* steps by one there") {
    Digits80 previous = 0;
    for (std::size_t n = 3; n <= 12; ++n) {
        const auto rough = critical_ratio(n);
        const Digits80 lowest =
            std::max(Digits80(1), Digits80(Digits80(rough.below) * (1 - Digits80(1e-15))));
        const auto [below, above] = bisect_critical<Digits80>(
            n, lowest, Digits80(Digits80(rough.above) * (1 + Digits80(1e-15))), 150);
        INFO("N " << n << " q_c " << above);
        CHECK(below > previous);
        CHECK(theorem(below).maximum() == n - 1);
        CHECK(theorem(above).maximum() == n);
        CHECK(theorem(Digits80(below * (1 - Digits80(1e-9)) < 1 ? Digits80(1) : below * (1 - Digits80(1e-9))))
                  .maximum() == n - 1);
        CHECK(theorem(Digits80(above * (1 + Digits80(1e-9)))).maximum() == n);
        // The orbit's flight number k exists on both sides; its margin changes sign and is nil at q_c. L27
        // turns the margin into a bound of the distance to the critical ratio.
        const std::size_t k = orbit_count(n);
        const auto missing = flights(orbit_of(n, Digits80(1 / below)), Digits80(1 / below));
        const auto hitting = flights(orbit_of(n, Digits80(1 / above)), Digits80(1 / above));
        REQUIRE(missing.size() == k);
        REQUIRE(hitting.size() >= k);
        CHECK(greatest_excess(missing[k - 1]) <= 0);
        CHECK(greatest_excess(hitting[k - 1]) > 0);
        CHECK(greatest_excess(hitting[k - 1]) - greatest_excess(missing[k - 1]) < 1e-50);
        for (const double gap : {1e-3, 1e-6, 1e-9}) {
            const Digits80 r = 1 / (above * (1 + Digits80(gap)));
            const Digits80 margin = greatest_excess(flights(orbit_of(n, r), r)[k - 1]);
            const Bounds least = n % 2 == 1 ? top_bounds(k - 1) : corner_bounds(k - 1);
            CHECK(1 / below - r <= margin / least.c * (1 + Digits80(1e-30)));
        }
        previous = above;
    }
}

TEST_CASE("theorem 2: simulated totals next to critical ratios stay at N - 1 below and reach N above") {
    for (std::size_t n = 4; n <= 9; ++n) {
        const auto critical = static_cast<double>(critical_ratio(n).above);
        for (const double gap : {-1e-3, -1e-6, 1e-3, 1e-6}) {
            const double ratio = critical * (1 + gap);
            const Dumbbell<Digits80> body{Digits80(ratio)};
            const std::size_t bound = gap < 0 ? n - 1 : n;
            Sampler sampler(ratio, 814);
            std::size_t most = 0;
            for (int i = 0; i < scaled(12); ++i) {
                // Around both extremal orbits at the scale of the gap.
                const double wide = std::sqrt(std::abs(gap)) * sampler.log_uniform(1e-3, 3);
                const BridgeState<Digits80> state =
                    i % 2 == 0 ? BridgeState<Digits80>{wide, wide * wide * sampler.log_uniform(1e-6, 1)}
                               : BridgeState<Digits80>{Digits80(turn_half / 2 - wide),
                                                       wide * wide * sampler.log_uniform(1e-6, 1)};
                most = std::max(most, total_collisions(body, contact_of(body, state)).collisions);
            }
            INFO("N " << n << " q " << ratio << " most " << most);
            CHECK(most <= bound);
            CHECK(most == bound);
        }
    }
}

TEST_CASE("theorem 7: the contacts' equations at critical ratios, and the poles of a slope") {
    for (const std::size_t n : {4U, 5U, 6U, 7U, 8U, 9U, 20U, 21U}) {
        const auto rough = critical_ratio(n);
        const auto [below, above] =
            bisect_critical<Digits80>(n, Digits80(Digits80(rough.below) * (1 - Digits80(1e-15))),
                                      Digits80(Digits80(rough.above) * (1 + Digits80(1e-15))), 150);
        const Digits80 r = 1 / below;  // flight k misses by a hair
        const auto all = flights(orbit_of(n, r), r);
        const Digits80 half_turn = pi<Digits80>();
        const Digits80 kappa = all.back().kappa, z = acos(kappa);
        REQUIRE(all.size() == orbit_count(n));
        const auto same = [](const Digits80& a, const Digits80& b) { return abs(a - b) < Digits80(1e-20); };
        Digits80 x = 0;  // of the contact before
        for (std::size_t j = 0; j + 1 < all.size(); ++j) {
            const Digits80 at = *hit_place(all[j]), slope = all[j].kappa, w = cos(at);
            CHECK(at > x);
            CHECK(same(sin(at) - (j == 0 ? Digits80(0) : sin(x)),
                       j > 0        ? Digits80(slope * (half_turn + x + at))
                       : n % 2 == 1 ? r
                                    : Digits80(r * (half_turn + at))));
            const Digits80 root = slope + sqrt(slope * slope + r), other = slope - sqrt(slope * slope + r);
            CHECK(same(root * other, -r));
            for (const Digits80& pole : {root, other}) {
                CHECK(same(slope * pole * pole + 2 * r * pole - r * slope, 2 * pole * (r + slope * slope)));
                CHECK(abs(pole) > Digits80(1e-3));
            }
            const Digits80 D = w * w - 2 * slope * w - r;
            CHECK(same((slope * w * w + 2 * r * w - r * slope) / D, all[j + 1].kappa));
            x = at;
        }
        CHECK(same(sin(z) - (all.size() > 1 ? sin(x) : Digits80(0)), kappa * (half_turn + x + z)));
    }
}
