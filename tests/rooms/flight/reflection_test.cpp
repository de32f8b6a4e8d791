#include "flight/reflection.hpp"

#include "catch.hpp"
#include "number/elementary.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

/// An interval around v, some thin, some wide; v is in it.
Interval spread_around(Random& random, double v) {
    if (random.coin()) {
        return Interval(v);
    }
    return {v - random.scaled(1e-16, 0.1), v + random.scaled(1e-16, 0.1)};
}

}  // namespace

TEST_CASE("A light wall's reflection encloses the vector reflection, formula (2)") {
    Random random(132);
    for (int i = 0; i < 20'000; ++i) {
        const double w = random.coin() ? random.uniform(0, 1) : random.scaled(1e-12, 1);
        const double r = random_r(random);
        const double kappa = random.uniform(-r, 1);
        const Vector<Real> out = reflect<Real>({Real(1), Real(kappa)}, Real(w), Real(r));
        const Real norm = Real(w) * w + r;
        const auto ours = reflect_at_light_wall(spread_around(random, kappa), spread_around(random, w),
                                                spread_around(random, r));
        // The ray comes in to the right; it goes back if out.angular < 0.
        if (!encloses(ours.denominator, Real(-out.angular * norm)) ||
            !encloses(ours.numerator, Real(out.vertical * norm))) {
            FAIL(say("kappa", kappa, "w", w, "r", r, "gives", ours.numerator, ours.denominator));
        }
    }
}

TEST_CASE("The reversed incoming ray at a light wall is enclosed, in units of r") {
    Random random(133);
    for (int i = 0; i < 20'000; ++i) {
        const double w = random.coin() ? random.uniform(0, 1) : random.scaled(1e-12, 1);
        const double r = random_r(random);
        const double lambda = random.uniform(0, 1 / r);
        // X leaves R to the left; its reflection is the velocity before, to be reversed.
        const Vector<Real> before = reflect<Real>({Real(-1), r * Real(lambda)}, Real(w), Real(r));
        const Real norm = Real(w) * w + r;
        const auto ours = reversed_at_light_wall(spread_around(random, lambda), spread_around(random, w),
                                                 spread_around(random, r));
        if (!encloses(ours.denominator, Real(before.angular * norm)) ||
            !encloses(ours.numerator, Real(-before.vertical * norm / r))) {
            FAIL(say("lambda", lambda, "w", w, "r", r, "gives", ours.numerator, ours.denominator));
        }
    }
}

TEST_CASE("The reversed steepness at the bridge is enclosed, formula (3)") {
    Random random(134);
    for (int i = 0; i < 20'000; ++i) {
        const double s = random.uniform(0, 1);
        const double r = random_r(random);
        const double eta = random.coin() ? random.uniform(0, 3) : random.scaled(1e-15, 1 / r);
        const Vector<Real> before =
            reflect<Real>({Real(-1), r * (Real(s) + eta)}, Real(-r * Real(s)), Real(r));
        // sigma X = -before flies to the right with slope r (eta' - s).
        const Real steepness = before.vertical / before.angular / r + s;
        const auto ours = reversed_steepness(spread_around(random, eta), spread_around(random, s),
                                             spread_around(random, r));
        if (!(before.angular < 0) || !encloses(ours, steepness)) {
            FAIL(say("eta", eta, "s", s, "r", r, "gives", ours, "exact", steepness));
        }
    }
}

TEST_CASE("The slope behind a contact of either end of a body encloses formula (1) of L0") {
    Random random(135);
    for (int i = 0; i < 20'000; ++i) {
        const double r = random_r(random), c = random.uniform(-1, 1), kappa = random.uniform(-1, 1);
        const double rho = random.coin() ? r : random.uniform(r, 1);
        const auto body = rho == r ? Body<Interval>::massless(Interval(r))
                                   : Body<Interval>::with_mass(Interval(rho), Interval(r));
        for (const End end : {End::light, End::heavy}) {
            const Real leverage(end == End::light ? 1.0 : rho);
            const Real wall = -turned(end, Real(leverage * c));
            const Vector<Real> out = reflect<Real>({Real(1), Real(kappa)}, wall, Real(r));
            const Real norm = (wall * wall + r) / leverage;
            const auto ours =
                reflect_at_end(end, spread_around(random, kappa), spread_around(random, c), body);
            if (!encloses(ours.denominator, Real(out.angular * norm)) ||
                !encloses(ours.numerator, Real(out.vertical * norm))) {
                FAIL(say("rho", rho, "r", r, "kappa", kappa, "c", c, "gives", ours.numerator,
                         ours.denominator));
            }
        }
    }
}

TEST_CASE("A ray along the bridge's tangent comes back as itself, a contact at the peak is symmetric") {
    CHECK(encloses(reversed_steepness(Interval(0), Interval(0.7), Interval(0.1)), Real(0)));
    const auto symmetric = reversed_steepness(Interval(0.4), Interval(0), Interval(0.1));
    CHECK(encloses(symmetric, Real(0.4)));
    CHECK(width(symmetric) < 1e-15);
}
