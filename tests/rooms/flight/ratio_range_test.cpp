// lowest_over and highest_over of flight/chart.hpp: one ray that bounds a ray of fixed height and slope (in
// units of r) over a whole range of mass ratios, by L5, or by L10 where it descends.
#include "catch.hpp"
#include "flight/chart.hpp"
#include "rays.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

/// The state after the first collision.
struct Step {
    bool hits;
    bool stays;
    Real x, kappa, c;
};

Step first_step(const Real& c, const Real& kappa, const Real& r) {
    const auto to_wall = kappa < 1 ? exact_flight(c, kappa) : Flight<Real>{false, Real(0), Real(0)};
    if (!to_wall.hits) {
        return {false, false, Real(0), Real(0), Real(0)};
    }
    const auto out = reflect<Real>({Real(1), kappa}, cos(to_wall.x), r);
    if (out.angular >= 0) {
        return {true, false, to_wall.x, Real(0), Real(0)};
    }
    const Real slope = out.vertical / -out.angular;
    return {true, true, to_wall.x, slope, sin(to_wall.x) + slope * (to_wall.x + pi_in<Real>())};
}

/// Whether the ray of the first step collides at least as often as that of the second, step by step.
bool dominates(const Step& low, const Step& high) {
    if (!high.hits) {
        return true;
    }
    if (!low.hits || low.x > high.x) {
        return false;
    }
    return !high.stays || (low.stays && low.kappa <= high.kappa && low.c <= high.c);
}

struct RatioSample {
    double c_lo, c_hi, lambda_lo, lambda_hi, r_lo, r_hi;
};

RatioSample random_ratio_sample(Random& random, bool descending) {
    RatioSample s{};
    s.r_hi = random_r(random, 1e-4);
    s.r_lo = s.r_hi * (1 - random.scaled(1e-15, 0.6));
    const double most = random.coin() ? 1 : 1 / s.r_hi;  // L10: r_hi c <= 1
    s.c_lo = random.coin() ? random.uniform(0, most) : random.scaled(1e-6, most);
    s.lambda_lo = descending ? -random.scaled(1e-6, 1) : random.uniform(0, std::min(3.0, 1 / s.r_hi));
    const bool thin = random.coin();
    s.c_hi = thin ? s.c_lo : std::min(most, s.c_lo + random.scaled(1e-12, 0.2));
    s.lambda_hi = thin ? s.lambda_lo : s.lambda_lo + random.scaled(1e-12, 0.2);
    return s;
}

std::string show(const RatioSample& s) {
    return say("c", s.c_lo, s.c_hi, "lambda", s.lambda_lo, s.lambda_hi, "r", s.r_lo, s.r_hi);
}

template <class I>
void check_sample(Random& random, const RatioSample& s) {
    const ScaledRay<I> ray{I(s.c_lo, s.c_hi), I(s.lambda_lo, s.lambda_hi)};
    const RatioRange<I> range{I(s.r_lo), I(s.r_hi)};
    const Ray<I> lowest = lowest_over(ray, range);
    const Ray<I> highest = highest_over(ray, range);
    const Step low = first_step(low_of<Real>(lowest.c), low_of<Real>(lowest.kappa), low_of<Real>(lowest.r));
    const Step high =
        first_step(high_of<Real>(highest.c), high_of<Real>(highest.kappa), high_of<Real>(highest.r));
    for (int j = 0; j < 4; ++j) {
        const double at = j < 2 ? j : random.uniform(0, 1);
        const Real r = j < 2 ? Real(j == 0 ? s.r_lo : s.r_hi) : Real(s.r_lo) + (Real(s.r_hi) - s.r_lo) * at;
        const Real c = Real(s.c_lo) + (Real(s.c_hi) - s.c_lo) * random.below(2);
        const Real lambda = Real(s.lambda_lo) + (Real(s.lambda_hi) - s.lambda_lo) * random.below(2);
        const Step step = first_step(r * c, r * lambda, r);
        if (low_of<Real>(lowest.r) > r || high_of<Real>(highest.r) < r || !dominates(low, step) ||
            !dominates(step, high)) {
            FAIL(say(s, "fails at r", r, "c", c, "lambda", lambda, "lowest", lowest.c, lowest.kappa,
                     "highest", highest.c, highest.kappa));
        }
    }
}

}  // namespace

TEST_CASE("Ascending rays are bounded over the ratio by their own ends") {
    Random random(161);
    for (int i = 0; i < 3'000; ++i) {
        check_sample<Interval>(random, random_ratio_sample(random, false));
    }
}

TEST_CASE("Descending rays are bounded over the ratio by the state after their first collision") {
    Random random(162);
    for (int i = 0; i < scaled(2'000); ++i) {
        check_sample<Interval>(random, random_ratio_sample(random, true));
    }
}

TEST_CASE("Bounds over the ratio hold in multiple precision too") {
    const PrecisionScope scope(128);
    Random random(163);
    for (int i = 0; i < 800; ++i) {
        check_sample<BigInterval>(random, random_ratio_sample(random, random.coin()));
    }
}

TEST_CASE("Bounds over the ratio hold with 8 to 40 bits, where rounding to the wrong side shows") {
    Random random(165);
    for (int i = 0; i < 2'000; ++i) {
        const PrecisionScope scope(8 + random.below(33));
        check_sample<BigInterval>(random, random_ratio_sample(random, random.coin()));
    }
}

TEST_CASE("Counts of the lowest and of the highest ray bound the counts at every ratio") {
    Random random(164);
    for (int i = 0; i < 1'000; ++i) {
        const RatioSample s = random_ratio_sample(random, random.coin());
        const ScaledRay<Interval> ray{Interval(s.c_lo, s.c_hi), Interval(s.lambda_lo, s.lambda_hi)};
        const RatioRange<Interval> range{Interval(s.r_lo), Interval(s.r_hi)};
        const auto lowest = lowest_over(ray, range);
        const auto highest = highest_over(ray, range);
        const Real r = Real(s.r_lo) + (Real(s.r_hi) - s.r_lo) * random.uniform(0, 1);
        const auto count = [&](const Real& c, const Real& kappa, const Real& ratio) {
            return ray_count(c, kappa, ratio, 40).hits;
        };
        const long most = count(Real(lowest.c.lo()), Real(lowest.kappa.lo()), Real(lowest.r.lo()));
        const long between = count(r * s.c_lo, r * s.lambda_lo, r);
        const long least_count = count(Real(highest.c.hi()), Real(highest.kappa.hi()), Real(highest.r.hi()));
        if (most < between || between < least_count) {
            FAIL(say(s, "counts", most, between, least_count, "at r", r));
        }
    }
}
