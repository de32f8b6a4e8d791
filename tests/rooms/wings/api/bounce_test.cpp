#include "dumbbell/bounce.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "attacks/oracle/ray_count.hpp"
#include "attacks/oracle/scalar.hpp"
#include "catch.hpp"
#include "dumbbell/error.hpp"
#include "scale.hpp"

using namespace dumbbell::api;
using dumbbell_oracle::Digits80;

namespace {

using PlainRay = dumbbell_oracle::Ray<Digits80>;

class Samples {
  public:
    double uniform(double lo, double hi) { return std::uniform_real_distribution(lo, hi)(engine_); }
    double log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }
    /// An end, or somewhere between.
    double in(const Interval& x) {
        const double t = uniform(-0.5, 1.5);
        return t <= 0 ? x.lo : t >= 1 ? x.hi : std::min(x.hi, x.lo + t * (x.hi - x.lo));
    }

  private:
    std::mt19937_64 engine_{20};
};

bool holds(const Interval& x, const Digits80& value) { return x.lo <= value && value <= x.hi; }

/// What the oracle's step says of one ray contradicts the enclosure.
bool contradicts(const Bounce& bounce, const PlainRay& ray, const Digits80& r) {
    const auto step = dumbbell_oracle::step(ray, r);
    switch (bounce.outcome) {
        case Outcome::undecided:
            return false;
        case Outcome::misses:
            return step.has_value();
        case Outcome::leaves:
            return !step || !holds(bounce.x, step->x) || step->next.has_value();
        case Outcome::flies_on: {
            if (!step || !holds(bounce.x, step->x)) {
                return true;
            }
            const auto kappa = dumbbell_oracle::slope_after(ray.kappa, step->x, r);
            return !kappa || !holds(bounce.ray.kappa, *kappa) ||
                   !holds(bounce.ray.c,
                          Digits80(sin(step->x) + *kappa * (step->x + dumbbell_oracle::pi<Digits80>())));
        }
    }
    return true;
}

bool allowed(const PlainRay& ray, const Digits80& r) {
    return ray.c >= 0 && ray.kappa >= -r &&
           (ray.kappa >= 0 || ray.c + ray.kappa * dumbbell_oracle::pi<Digits80>() / 2 < 1);
}

}  // namespace

TEST_CASE("Every ray of a box bounces as its enclosure says, by the oracle in 80 digits") {
    Samples samples;
    const long boxes = scaled(4'000);
    long seen[4] = {};
    for (long i = 0; i < boxes; ++i) {
        const auto q = static_cast<long>(samples.log_uniform(1, i % 2 == 0 ? 1e5 : 10));
        const MassRatio ratio(i % 3 == 0 ? std::to_string(q) + ":" + std::to_string(q + 1 + q / 100)
                                         : std::to_string(q));
        const Interval& r = ratio.light_over_heavy();
        const double width = i % 5 == 0 ? 0 : samples.log_uniform(1e-12, 0.5);
        const double c = samples.uniform(0, 1.2) - (i % 7 == 0 ? 0.1 : 0);
        const double kappa =
            i % 2 == 0 ? samples.uniform(-1.1 * r.hi, 1.1) : samples.uniform(-r.hi, 3 * r.hi);
        const Ray box{{c, c + width}, {kappa, kappa + width}};
        if (box.c.hi < 0 || box.kappa.hi < -r.hi) {
            continue;
        }
        const Bounce bounce = enclose_bounce(ratio, box);
        ++seen[static_cast<int>(bounce.outcome)];
        for (int k = 0; k < 8; ++k) {
            const PlainRay ray{samples.in(box.c), samples.in(box.kappa)};
            const Digits80 light = samples.in(r);
            if (r.lo <= light && light <= r.hi && allowed(ray, light) && contradicts(bounce, ray, light)) {
                FAIL("q " << ratio.lo() << " c " << ray.c << " kappa " << ray.kappa << " outcome "
                          << static_cast<int>(bounce.outcome) << " x " << bounce.x.lo << ' ' << bounce.x.hi);
            }
        }
    }
    for (int outcome = 0; outcome < 4; ++outcome) {  // each was put to the test
        CAPTURE(outcome);
        CHECK(seen[outcome] > boxes / 40);
    }
}

TEST_CASE("A thin ray is decided, and its enclosure is thin") {
    const Bounce bounce = enclose_bounce(MassRatio("100"), ray_from_light_wall({0.1, 0.1}, {0.02, 0.02}));
    REQUIRE(bounce.outcome == Outcome::flies_on);
    CHECK(bounce.x.hi - bounce.x.lo < 1e-14);
    CHECK(bounce.ray.kappa.hi - bounce.ray.kappa.lo < 1e-14);
    CHECK(bounce.ray.c.hi - bounce.ray.c.lo < 1e-13);
}

TEST_CASE("A ray from a light wall crosses the corner's vertical at sin x + kappa (x + pi)") {
    Samples samples;
    for (int i = 0; i < 1000; ++i) {
        const double x = samples.uniform(0, 1.5), kappa = samples.uniform(-0.5, 0.9);
        const Interval at{x, std::min(1.57, x + samples.log_uniform(1e-9, 0.1))}, slope{kappa, kappa + 0.01};
        const Ray ray = ray_from_light_wall(at, slope);
        const Digits80 e = samples.in(at), k = samples.in(slope);
        CHECK(holds(ray.c, Digits80(sin(e) + k * (e + dumbbell_oracle::pi<Digits80>()))));
        CHECK((ray.kappa.lo == slope.lo && ray.kappa.hi == slope.hi));
    }
}

TEST_CASE("Following the bounces of one ray counts as the oracle does") {
    const MassRatio ratio("1000");
    Ray ray = ray_from_light_wall({0, 0}, {0, 0});
    std::size_t hits = 0;
    Bounce bounce;
    while ((bounce = enclose_bounce(ratio, ray)).outcome == Outcome::flies_on) {
        ++hits;
        ray = bounce.ray;
    }
    REQUIRE(bounce.outcome != Outcome::undecided);
    hits += bounce.outcome == Outcome::leaves ? 1 : 0;
    CHECK(hits == dumbbell_oracle::ray_count(PlainRay{0, 0}, Digits80(1) / 1000));
    CHECK(hits > 10);
}

TEST_CASE("Only the part of a box with c >= 0 and kappa >= -1/q counts") {
    const MassRatio ten("10");
    const Bounce whole = enclose_bounce(ten, {{-1, 0}, {-1, 0}});
    const Bounce part = enclose_bounce(ten, {{0, 0}, {-ten.light_over_heavy().hi, 0}});
    REQUIRE(whole.outcome == Outcome::flies_on);
    CHECK((whole.x.lo == part.x.lo && whole.x.hi == part.x.hi));
    CHECK((whole.ray.kappa.lo == part.ray.kappa.lo && whole.ray.kappa.hi == part.ray.kappa.hi));
}

TEST_CASE("What is too wide, or a touch, is undecided") {
    CHECK(enclose_bounce(MassRatio("10"), {{0, 1.5}, {0, 0.5}}).outcome == Outcome::undecided);
    CHECK(enclose_bounce(MassRatio("10"), {{1, 1}, {0, 0}}).outcome == Outcome::undecided);
    CHECK(enclose_bounce(MassRatio("1e1000"), {{0, 0}, {0, 0}}).outcome == Outcome::undecided);
}

TEST_CASE("What is no box of rays is refused") {
    const MassRatio ten("10");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Interval& bad : {Interval{nan, 1}, Interval{0, nan}, Interval{1, 0}, Interval{0, infinity}}) {
        CHECK_THROWS_AS(enclose_bounce(ten, {bad, {0, 0}}), InputError);
        CHECK_THROWS_AS(enclose_bounce(ten, {{0, 0}, bad}), InputError);
        CHECK_THROWS_AS(ray_from_light_wall(bad, {0, 0}), InputError);
        CHECK_THROWS_AS(ray_from_light_wall({0, 0}, bad), InputError);
    }
    CHECK_THROWS_AS(enclose_bounce(ten, {{-2, -1}, {0, 0}}), InputError);
    CHECK_THROWS_AS(enclose_bounce(ten, {{0, 0}, {-1, -0.2}}), InputError);
    CHECK_THROWS_AS(ray_from_light_wall({-1, 0}, {0, 0}), InputError);
    CHECK_THROWS_AS(ray_from_light_wall({1, 1.6}, {0, 0}), InputError);
}
