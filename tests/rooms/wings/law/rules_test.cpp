#include "catch.hpp"
#include "law/bulk_rule.hpp"
#include "law/end_rule.hpp"
#include "law/functions.hpp"
#include "law/layer_rule.hpp"
#include "rooms/number/random.hpp"
#include "rooms/wings/law/direct.hpp"

using namespace dumbbell;
using namespace dumbbell::law;
using namespace dumbbell_test;

namespace {

/// Around a point, but not below 0.
Interval around(double x, double radius) { return {std::max(0.0, x - radius), x + radius}; }

}  // namespace

TEST_CASE("the layer's rule contains steps evaluated directly") {
    Random random(20);
    int seen = 0;
    while (seen < 60) {
        const double U = 0.9 * std::pow(10, -4 * random.uniform(0, 1)),
                     rho = 0.2 * std::pow(10, -2 * random.uniform(0, 1));
        const DirectStep step = step_with(U, rho, Real(-0.02 + 5.3 * random.uniform(0, 1)));
        if (step.eps > Real(1) / 1000) {
            continue;
        }
        ++seen;
        const Real T = tau(step.u, step.j) / (2 * step.eps);
        const Real D = T - 1 - tau(step.v, step.j_v) / (2 * step.eps);
        const Real s = sqrt(step.eps),
                   y = sqrt(sqrt(Real(3)) * dumbbell_oracle::pi<Real>()) * s * (sqrt(T) + sqrt(T - 1));
        const Real excess = (1 - D / comparison(s, T)) / y - 5 / (3 * dumbbell_oracle::pi<Real>());
        const Real d = Real(rho) * U, ehat = step.eps / (d * U);
        const Real drift = Real(U) * U * (step.j - step.j_v) / (d * d * d) / (2 * ehat * ehat);
        CAPTURE(U, rho, excess, drift);
        for (const double radius : {0.0, 1e-5}) {
            const LayerBox box{around(U, radius * U), around(rho, radius * rho)};
            const LayerBounds found = layer_bounds(box);
            CHECK(contains(found.excess, excess));
            CHECK(contains(found.drift, drift));
            CHECK(contains(found.at_zero, 1));
            CHECK(contains(found.first, 0));
            CHECK((radius > 0 || width(found.excess) < 0.03));
            CHECK_FALSE(certainly_beyond(box));
        }
    }
}

TEST_CASE("the layer's rule is sharp at U = 0 and rho = 0") {
    const LayerBounds found = layer_bounds({Interval(0, 1e-9), Interval(0, 1e-9)});
    CHECK(contains(found.excess, 0));
    CHECK(width(found.excess) < 1e-8);
    CHECK(std::abs(approximate(found.at_zero) - 1) < 1e-9);
    CHECK(width(found.at_zero) < 1e-9);
}

TEST_CASE("the layer's rule closes no box in which it fails, or does not apply") {
    CHECK_FALSE(closes({Interval(0, 0.9), Interval(0, 0.2)}));  // too wide
    CHECK_FALSE(closes({Interval(0.5, 0.6), Interval(0, 0.2)}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(closes({Interval(nan), Interval(0.1)}));
    CHECK_FALSE(closes({Interval(0.1), Interval(nan)}));
    CHECK_FALSE(certainly_beyond({Interval(nan), Interval(nan)}));
    CHECK(certainly_beyond({Interval(0.5), Interval(0.1)}));
}

TEST_CASE("the bulk's rule contains steps evaluated directly") {
    Random random(21);
    for (int i = 0; i < 40; ++i) {
        const double th = 0.01 + 0.78 * random.uniform(0, 1);
        const Real eps = pow(Real(10), Real(-3 - 4 * random.uniform(0, 1)));
        // The step of this eps and angle: its mid-point by Q, its half width by the clock's rule.
        const Real Q = dumbbell_oracle::pi<Real>() / 2 + eps * eps * Real(2 * random.uniform(0, 1) - 1);
        const Real F = Q / cos(Real(th)), U = dumbbell_oracle::pi<Real>() - F;
        const DirectStep step(U, asin(eps * tan(Real(th)) * F / sin(U)) / U, Q);
        CHECK(abs(step.eps - eps) < 1e-50);
        if (step.alpha() < 0) {
            continue;  // no state of an orbit: its clock has two values there
        }
        const Real D =
            (tau_by_angle(step.alpha(), step.j) - tau_by_angle(step.alpha_v(), step.j_v)) / (2 * eps) - 1;
        const Real way = step.alpha_v() - step.alpha();
        CAPTURE(th, eps);
        for (const double radius : {0.0, 1e-4}) {
            const double size = static_cast<double>(eps);
            const Interval all =
                radius > 0 ? Interval(0, 0.001) : Interval(size * 0.999, std::min(0.001, size * 1.001));
            const BulkBounds found = bulk_bounds(around(th, radius), all, P_at(around(th, radius)));
            CHECK(contains(found.defect, 2 * D / (eps * way)));
            CHECK(contains(found.fall, (step.j - step.j_v) / (eps * eps * way)));
        }
    }
}

TEST_CASE("the rule of the end contains ends evaluated directly") {
    Random random(22);
    const Real pi = dumbbell_oracle::pi<Real>(), k0 = dumbbell_oracle::law::k0<Real>();
    for (int i = 0; i < 40; ++i) {
        const double d = 0.0713 * std::pow(10, -3 * random.uniform(0, 1));
        const Real u = 2 * Real(d);
        // Tangent: 1 - cos u + rk = kappa (2 pi - u).
        Real kappa = 0;
        for (int k = 0; k < 200; ++k) {
            const Real rk = sqrt(1 - kappa * kappa) + kappa * asin(kappa) - 1;
            kappa = (1 - cos(u) + rk) / (2 * pi - u);
        }
        // alpha, th by J = pi/2 - share eps^2/u^3.
        const Real wanted_share = Real(5.2 * random.uniform(0, 1));
        Real th = acos(pi / 2 / (pi - Real(d))), eps = 0, J = 0;
        for (int k = 0; k < 200; ++k) {
            eps = kappa / tan(th);
            J = pi / 2 - wanted_share * eps * eps / (u * u * u);
            th = acos(J / (pi - u)) + atan(eps / sin(u));
        }
        const Real e_end = tau(u, J) / (2 * eps) - 1, s = sqrt(eps);
        CAPTURE(d, eps);
        for (const double radius : {0.0, 1e-5}) {
            const EndBounds found = end_bounds(around(d, radius));
            CHECK(contains(found.surplus, (e_end - k0 * s) / eps));
            CHECK(contains(found.at_zero, k0));
        }
        CHECK_FALSE(certainly_beyond(around(d, 0)));
    }
    CHECK(certainly_beyond(Interval(0.09)));
}
