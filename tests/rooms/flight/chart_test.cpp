#include "flight/chart.hpp"

#include "catch.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

const Real pi_exactly = pi_in<Real>();

double corner_distance(Random& random) {
    switch (random.below(4)) {
        case 0:
            return random.scaled(1e-12, 1);
        case 1:
            return 0x1.921fb54442d18p+0 - random.scaled(1e-12, 0.5);
        default:
            return random.uniform(0, 1.57);
    }
}

/// Some thin, some wide; v is in it.
Interval around(Random& random, double v) {
    return random.coin()
               ? Interval(v)
               : Interval(std::max(0.0, v - random.scaled(1e-16, 0.1)), v + random.scaled(1e-16, 0.1));
}

/// The height above the floor's zero that a straight line of the given slope has reached after `run`.
Real height(const Real& from, const Real& slope, const Real& run) { return from + slope * run; }

}  // namespace

TEST_CASE("A position encloses its sine and cosine and never leaves [0, pi/2]") {
    Random random(151);
    for (int i = 0; i < 10'000; ++i) {
        const double e = corner_distance(random);
        const auto at = position(around(random, e));
        if (!encloses(at.e, Real(e)) || !encloses(at.sin_e, Real(sin(Real(e)))) ||
            !encloses(at.cos_e, Real(cos(Real(e))))) {
            FAIL(say("e =", e, "at", at.e, at.sin_e, at.cos_e));
        }
        if (at.e.hi() > half_pi<Interval>().hi() || at.sin_e.lo() < 0 || at.cos_e.lo() < 0) {
            FAIL(say("beyond the peak: e =", e, "at", at.e, at.sin_e, at.cos_e));
        }
    }
    for (const double beyond : {1.58, 2.0, 1e9}) {
        const auto peak = position(Interval(beyond));
        CHECK(encloses(peak.e, Real(pi_exactly / 2)));
        CHECK(width(peak.e) < 1e-15);
        CHECK(encloses(peak.sin_e, Real(1)));
        CHECK(peak.cos_e.lo() == 0);
        CHECK(peak.cos_e.hi() < 1e-15);
    }
}

TEST_CASE("The outgoing ray of the chart bridge is where the geometry puts it") {
    Random random(152);
    for (int i = 0; i < 10'000; ++i) {
        const double e = corner_distance(random);
        const double eta = random.coin() ? random.uniform(0, 3) : random.scaled(1e-12, 1e3);
        const double r = random_r(random);
        const auto scaled = bridge_outgoing(position(around(random, e)), around(random, eta));
        const auto ray = at_ratio(scaled, Interval(r));
        // From psi = pi/2 - e at height r sin e, r eta steeper than the tangent, to psi = -pi/2.
        const Real slope = r * Real(cos(Real(e))) + r * Real(eta);
        const Real c = height(r * sin(Real(e)), slope, pi_exactly - e);
        if (!encloses(ray.kappa, slope) || !encloses(ray.c, c) || ray.r.lo() != r) {
            FAIL(say("e", e, "eta", eta, "r", r, "ray", ray.c, ray.kappa));
        }
    }
}

TEST_CASE(
    "The reversed incoming ray of the chart bridge is where the geometry puts it, never below the corner") {
    Random random(153);
    for (int i = 0; i < 10'000; ++i) {
        const double e = corner_distance(random);
        const double eta = random.coin() ? random.uniform(0, 3) : random.scaled(1e-12, 1e3);
        const double r = random_r(random);
        const auto scaled = bridge_reversed(position(around(random, e)), around(random, eta), Interval(r));
        const auto ray = at_ratio(scaled, Interval(r));
        const Real s = cos(Real(e));
        const auto before = reflect<Real>({Real(-1), r * (s + eta)}, Real(-r * s), Real(r));
        const Real slope = before.vertical / before.angular;  // of the reversed velocity, to the right
        const Real c = height(r * sin(Real(e)), slope, Real(e));
        if (!encloses(ray.kappa, slope) || !high_at_least(ray.c, c) || !low_at_most(ray.c, c) ||
            scaled.c.lo() < 0) {
            FAIL(say("e", e, "eta", eta, "r", r, "ray", ray.c, ray.kappa, "exact", c, slope));
        }
    }
}

TEST_CASE("The rays of the chart light are where the geometry puts them") {
    Random random(154);
    for (int i = 0; i < 10'000; ++i) {
        const double e = corner_distance(random);
        const double kappa = random.uniform(0, 1);
        const double r = random_r(random);
        const auto ray = light_outgoing(position(around(random, e)), around(random, kappa), Interval(r));
        // From psi = pi/2 + e at height sin e to psi = -pi/2.
        const Real c = height(sin(Real(e)), Real(kappa), pi_exactly + e);
        if (!encloses(ray.c, c) || !encloses(ray.kappa, Real(kappa))) {
            FAIL(say("e", e, "kappa", kappa, "ray", ray.c, ray.kappa));
        }
    }
}

TEST_CASE("Charts in multiple precision agree with those in double") {
    const PrecisionScope scope(128);
    Random random(155);
    for (int i = 0; i < 2'000; ++i) {
        const double e = corner_distance(random);
        const double eta = random.uniform(0, 2);
        const double r = random_r(random);
        const auto fine = bridge_reversed(position(BigInterval(e)), BigInterval(eta), BigInterval(r));
        const auto coarse = bridge_reversed(position(Interval(e)), Interval(eta), Interval(r));
        const bool inside = coarse.c.lo() <= fine.c.lo() && fine.c.hi() <= coarse.c.hi() &&
                            coarse.lambda.lo() <= fine.lambda.lo() && fine.lambda.hi() <= coarse.lambda.hi();
        if (!inside || width(fine.c) > 1e-35 || width(coarse.c) > 1e-13) {
            FAIL(say("e", e, "eta", eta, "r", r, "coarse", coarse.c, coarse.lambda, "fine", fine.c,
                     fine.lambda));
        }
    }
}

TEST_CASE("Charts with 8 to 40 bits, where rounding to the wrong side shows, still hold the exact rays") {
    Random random(156);
    for (int i = 0; i < 5'000; ++i) {
        const PrecisionScope scope(8 + random.below(33));
        const Real e = corner_distance(random);
        const Real eta = random.uniform(0, 2);
        const Real r = random_r(random);
        const auto big = [](const Real& x) { return BigInterval(x.convert_to<double>()); };
        const auto at = position(big(e));
        const auto out = bridge_outgoing(at, big(eta));
        const auto back = bridge_reversed(at, big(eta), big(r));
        const Real s = cos(e);
        const auto before = reflect<Real>({Real(-1), r * (s + eta)}, Real(-r * s), r);
        const Real back_slope = before.vertical / before.angular / r;
        const auto light = light_outgoing(at, big(eta / 2), big(r));
        if (!encloses(out.lambda, Real(s + eta)) ||
            !encloses(out.c, height(sin(e), s + eta, pi_exactly - e)) || !encloses(back.lambda, back_slope) ||
            !encloses(back.c, height(sin(e), back_slope, e)) ||
            !encloses(light.c, height(sin(e), eta / 2, pi_exactly + e))) {
            FAIL(say("bits", PrecisionScope::current(), "e", e, "eta", eta, "r", r));
        }
    }
}

TEST_CASE("The lowest ray over a range of ratios falls no faster than the bridge ends") {
    const RatioRange<Interval> range{Interval(0.25), Interval(0.5)};
    CHECK(lowest_over(ScaledRay<Interval>{Interval(0.5), Interval(-1.5)}, range).kappa.lo() == Approx(-0.25));
    CHECK(lowest_over(ScaledRay<Interval>{Interval(0.5), Interval(-0.5)}, range).kappa.lo() ==
          Approx(-0.125));
}

TEST_CASE("A chart state of NaN gives rays about which nothing is certain") {
    const Interval bad(not_a_number);
    const auto at = position(Interval(0.5));
    const auto out = bridge_outgoing(at, bad);
    CHECK(std::isnan(out.c.lo()));
    CHECK(std::isnan(out.lambda.lo()));
    const auto back = bridge_reversed(at, bad, Interval(0.1));
    CHECK(std::isnan(back.c.lo()));
    const auto lost = position(bad);
    CHECK(std::isnan(bridge_outgoing(lost, Interval(0.1)).c.lo()));
}
