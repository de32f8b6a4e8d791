#include "number/elementary.hpp"

#include <cmath>

#include "angles.hpp"
#include "catch.hpp"
#include "random.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

bool within_one(const Interval& x) { return -1 <= x.lo() && x.lo() <= x.hi() && x.hi() <= 1; }

}  // namespace

TEST_CASE("sin, cos and sin_cos agree, within [-1, 1]") {
    Random random(22);
    for (int i = 0; i < 10'000; ++i) {
        const Interval x = adversarial_angles(random);
        const Interval sine = sin(x);
        const Interval cosine = cos(x);
        const SinCos<Interval> both = sin_cos(x);
        if (!within_one(sine) || !within_one(cosine) || !is(both.sin, sine.lo(), sine.hi()) ||
            !is(both.cos, cosine.lo(), cosine.hi())) {
            FAIL(say("x =", x, "sin", sine, both.sin, "cos", cosine, both.cos));
        }
    }
}

TEST_CASE("An extremum in the argument, or at its very end, is in the range") {
    for (int k = -40; k <= 40; ++k) {
        const double peak = (2 * k + 0.5) * 0x1.921fb54442d18p+1;
        const double trough = (2 * k - 0.5) * 0x1.921fb54442d18p+1;
        const double before = neighbour(peak, -8);
        CAPTURE(k, peak);
        CHECK(sin(Interval(before, neighbour(peak, 8))).hi() == 1);
        CHECK(sin(Interval(peak - 1, peak + 1)).hi() == 1);
        CHECK(sin(Interval(trough - 1, trough + 1)).lo() == -1);
        CHECK(is(sin(Interval(trough, peak + 2)), -1, 1));
        CHECK(sin(Interval(peak - 1.5, peak - 1)).hi() < 0.9);
        const double turn = 2 * k * 0x1.921fb54442d18p+1;
        CHECK(cos(Interval(turn - 0.5, turn + 0.25)).hi() == 1);
        CHECK(cos(Interval(turn - 4, turn - 3)).lo() == -1);
        CHECK(cos(Interval(turn + 1, turn + 2)).hi() < 0.9);
    }
    CHECK(cos(Interval(0, 0)).hi() == 1);
    CHECK(cos(Interval(0, 0x1p-1074)).hi() == 1);
    CHECK(cos(Interval(-0x1p-1074, 0)).hi() == 1);
}

TEST_CASE("Arguments that are far out, wide, infinite or NaN give [-1, 1]") {
    for (const Interval& x : {Interval(0x1.0000000000001p20), Interval(1e300), Interval(-1e22),
                              Interval(0, 6.3), Interval(-infinity, infinity), Interval(0, infinity),
                              Interval(-infinity, 3), Interval(-1e300, 1e300), Interval(5, 1e9)}) {
        CAPTURE(show(x));
        CHECK(is(sin(x), -1, 1));
        CHECK(is(cos(x), -1, 1));
    }
    // No number is in NaN: both [-1, 1] and NaN are right, a smaller range is not.
    for (const Interval& x : {Interval(not_a_number), Interval(1, 0)}) {
        CHECK_FALSE(sin(x).lo() > -1);
        CHECK_FALSE(sin(x).hi() < 1);
        CHECK_FALSE(cos(x).lo() > -1);
        CHECK_FALSE(cos(x).hi() < 1);
    }
}

TEST_CASE("The ends of asin are certified by sine itself, not believed from the library") {
    Random random(24);
    for (int i = 0; i < 20'000; ++i) {
        const double v = adversarial_sine(random, adversarial_angle);
        const Interval ours = asin(Interval(v));
        const double quarter = half_pi<Interval>().hi();
        if ((ours.lo() > -quarter && sin(Interval(ours.lo())).hi() > v) ||
            (ours.hi() < quarter && sin(Interval(-ours.hi())).hi() > -v)) {
            FAIL(say("asin of", v, "is", ours));
        }
    }
}

TEST_CASE("asin cuts its argument to [-1, 1] and says nothing false of NaN") {
    const Interval quarter = half_pi<Interval>();
    CHECK(is(asin(Interval(-2, 3)), -quarter.hi(), quarter.hi()));
    CHECK(is(asin(Interval(-infinity, infinity)), -quarter.hi(), quarter.hi()));
    CHECK(asin(Interval(0.5, 7)).hi() == quarter.hi());
    CHECK(asin(Interval(0.5, 7)).lo() == asin(Interval(0.5)).lo());
    CHECK_FALSE(asin(Interval(not_a_number)).lo() > -quarter.lo());
    CHECK_FALSE(asin(Interval(not_a_number)).hi() < quarter.lo());
}

TEST_CASE("half_pi has the neighbouring doubles around MPFR's") {
    Tightest exact;
    exact.add([](mpfr_ptr to, mpfr_rnd_t rounding) { mpfr_const_pi(to, rounding); });
    CHECK(is(half_pi<Interval>(), exact.lo / 2, exact.hi / 2));
}
