#include "flight/bridge_once.hpp"

#include <optional>

#include "catch.hpp"
#include "reference.hpp"
#include "rooms/number/random.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using dumbbell_test::Random;
using dumbbell_test::Real;

namespace {

/// A contact with the bridge: distance t from the right corner, steepness eta, r.
struct ContactOnce {
    double t, eta, r;
};

/// What comes back of the ray (c, kappa) from the light wall: its slope, and P of lemma L19; nothing if it
/// does not.
struct Back {
    Real slope, p;
};
std::optional<Back> comes_back(const Real& c, const Real& lambda, const Real& r) {
    const Real kappa = r * lambda;
    if (kappa >= 1) {
        return std::nullopt;
    }
    const auto to_wall = dumbbell_test::exact_flight<Real>(c, kappa);
    if (!to_wall.hits) {
        return std::nullopt;
    }
    const Real w = cos(to_wall.x);
    const auto out = dumbbell_test::reflect<Real>({Real(1), kappa}, w, r);
    if (out.angular >= 0) {
        return std::nullopt;
    }
    return Back{out.vertical / -out.angular, (lambda + 1) * (w * w + 2 * r * w - r) + 2 * (1 - w) * (w + r)};
}

/// Often at the corners of the chart, at small eta, and at large ratios.
ContactOnce random_contact(Random& random) {
    const auto edge = [&](double lo, double hi) {
        const double part = (hi - lo) * (random.coin() ? random.uniform(0, 1) : random.scaled(1e-12, 1));
        return random.coin() ? lo + part : hi - part;
    };
    const double q = random.scaled(1, 1e6);
    return {edge(0, 3.14159265358979), edge(0, q), 1 / q};
}

}  // namespace

TEST_CASE("L19: slopes below r come back exactly where P is negative") {
    // Rays that are no contact's: steeper downwards than the bridge anywhere.
    Random random(1902);
    int below = 0, above = 0;
    for (int i = 0; i < scaled(5'000); ++i) {
        const Real r(random.scaled(1e-4, 1));
        const auto found = comes_back(Real(random.uniform(0, 1)), Real(random.uniform(-5, 1)), r);
        if (found && abs(found->slope - r) > 1e-30) {
            ++(found->slope < r ? below : above);
            CHECK((found->slope < r) == (found->p < 0));
        }
    }
    CHECK(below > 100);
    CHECK(above > 100);
}

TEMPLATE_TEST_CASE("L19: boxes whose rays come back with slope r at least are recognized", "", Interval,
                   BigInterval) {
    using I = TestType;
    Random random(1903);
    for (int i = 0; i < 500; ++i) {
        const ContactOnce at = random_contact(random);
        const RatioRange<I> thin{I(at.r), I(at.r)};
        CAPTURE(at.t, at.eta, at.r);
        CHECK(certainly_once(I(at.t), I(at.eta), thin));
        CHECK(certainly_once(I(4), I(0.0, 2 / at.r), thin));
    }
    CHECK(certainly_once(I(4), I(0.0, 128.0), RatioRange<I>{I(0.01), I(0.0103)}));
    CHECK_FALSE(certainly_once(I(4), I(0.0, 128.0), RatioRange<I>{I(0.01), I(1)}));
}
