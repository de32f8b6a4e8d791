#include "flight/batch/step.hpp"

#include <catch2/catch.hpp>
#include <optional>

#include "flight/batch/aim.hpp"
#include "flight/batch/lower_step.hpp"
#include "flight/batch/upper_step.hpp"
#include "rooms/flight/rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

// L39 is about every ray with c >= 0, -1 <= kappa < 1, 0 < r <= 1 and every z of [0, half_pi_hi]: here they
// are as extreme as doubles allow. A bound x of the contact is taken as the contact itself, which it is for
// another c: so the next state is checked wherever z lies, and not only near contacts.

namespace {

struct Place {
    DoubleRay ray;
    double z;
};

double extreme_r(Random& random) {
    switch (random.below(4)) {
        case 0:
            return random.scaled(least, 1);
        case 1:
            return random.scaled(1e-17, 1e-11);
        default:
            return random_r(random, 1e-10);
    }
}

double extreme_kappa(Random& random, double r) {
    switch (random.below(7)) {
        case 0:
            return random.coin() ? -r : -1.0;
        case 1:
            return 1 - random.scaled(0x1p-53, 0.5);
        case 2:
            return random.sign() * random.scaled(least, 0.5);
        case 3:
            return r * random.uniform(-1, 3);
        default:
            return random.uniform(-1, 1);
    }
}

Place extreme_place(Random& random) {
    const double r = extreme_r(random);
    const double kappa = std::min(extreme_kappa(random, r), neighbour(1, -1));
    const double top = std::acos(std::max(kappa, 0.0));
    const double peak = std::max(0.0, std::sin(top) - kappa * top);
    const double x = random.coin() ? random.uniform(0, top) : top * random.scaled(1e-14, 1);
    const double heights[] = {0,
                              random.scaled(least, 1),
                              peak * (1 + random.sign() * random.scaled(1e-17, 0.1)),
                              std::max(0.0, std::sin(x) - kappa * x),
                              std::max(0.0, std::sin(x) - kappa * x),
                              random.below(20) == 0 ? greatest : random.scaled(0.5, 4)};
    const double c = heights[random.below(6)];
    const double near = x * (1 + random.sign() * random.scaled(1e-17, 0.1));
    const double places[] = {0,
                             half_pi_hi,
                             near,
                             near,
                             random.scaled(least, 1),
                             random.uniform(0, half_pi_hi),
                             batch::first_aim(c, kappa).z};
    return {{c, kappa, r}, std::clamp(places[random.below(7)], 0.0, half_pi_hi)};
}

/// sin x - kappa x - c, and by how much it may be off.
Real gap(const DoubleRay& ray, const Real& x) { return sin(x) - ray.kappa * x - ray.c; }
Real tolerance(const DoubleRay& ray, const Real& x) { return Real("1e-55") * (x + ray.c); }

/// What L4 says of a ray of this slope that meets the wall at x; nothing if it does not come back.
struct Next {
    Real c, kappa;
};
std::optional<Next> after(const DoubleRay& ray, const Real& x) {
    const Real w = cos(x);
    const Real d = w * w - 2 * ray.kappa * w - ray.r;
    if (!(d > Real("1e-55"))) {
        return std::nullopt;
    }
    const Real kappa = (ray.kappa * w * w + 2 * ray.r * w - Real(ray.r) * ray.kappa) / d;
    return Next{sin(x) + kappa * (x + pi_in<Real>()), kappa};
}

}  // namespace

TEST_CASE("L39 (a)-(d): lower bounds hold for rays and tangents as extreme as doubles allow") {
    Random random(441);
    int bounded = 0;
    int beyond = 0;
    int followed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto [ray, z] = extreme_place(random);
        const auto at = batch::sin_cos(z);
        const Real top = ray.kappa > 0 ? Real(acos(Real(ray.kappa))) : Real(pi_in<Real>() / 2);
        const auto broken = [&, &ray = ray, &z = z](const char* what) { FAIL(say(what, ray, "z", z)); };
        if (batch::strict_miss(z, at, ray.c, ray.kappa) && gap(ray, top) >= 0) {
            broken("(b): no miss");
        }
        const auto contact = batch::Lower::contact(z, at, ray.c, ray.kappa);
        if (!(at.cos - ray.kappa - batch::padding(at.cos + std::abs(ray.kappa)) > 0)) {
            continue;
        }
        ++bounded;
        const Real x = Real(z) + Real(contact.shift);
        const Real end = std::min(x, top);
        if (x < 0 || gap(ray, end) > tolerance(ray, end)) {
            broken("(a): a contact before the bound");
        }
        if (contact.beyond) {
            ++beyond;
            if (gap(ray, top) >= 0) {
                broken("(a): a contact beyond the peak");
            }
        }
        if (x > pi_in<Real>() / 2) {
            continue;
        }
        const auto next = batch::Lower::bounce(z, at, contact.shift, ray.kappa, ray.r);
        const auto exact = after(ray, x);
        if (!exact) {
            continue;
        }
        if (next.ends) {
            broken("(d): ends too early");
        }
        if (next.follows) {
            ++followed;
            if (!(next.kappa > 0 && Real(next.kappa) <= exact->kappa && next.c >= 0 &&
                  Real(next.c) <= exact->c)) {
                broken("(c), (d): no lower state");
            }
        }
    }
    CHECK(bounded > 50'000);
    CHECK(beyond > 3'000);
    CHECK(followed > 20'000);
}

TEST_CASE("L39 (e), (f): upper bounds hold for rays and tangents as extreme as doubles allow") {
    Random random(442);
    int certain = 0;
    int followed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto [ray, z] = extreme_place(random);
        const auto at = batch::sin_cos(z);
        const auto contact = batch::Upper::contact(z, at, ray.c, ray.kappa);
        if (!contact.close) {
            continue;
        }
        ++certain;
        const Real x = Real(z) + Real(contact.shift);
        if (x < 0 || x > pi_in<Real>() / 2 || gap(ray, x) <= -tolerance(ray, x)) {
            FAIL(say("(e): no contact up to the bound:", ray, "z", z));
        }
        const auto next = batch::Upper::bounce(z, at, contact.shift, ray.kappa, ray.r);
        if (!next.follows || ray.kappa < -ray.r) {  // no ray of the domain is as flat as that
            continue;
        }
        ++followed;
        const auto exact = after(ray, x);
        if (!exact || !(Real(next.kappa) >= exact->kappa && Real(next.c) >= exact->c)) {
            FAIL(say("(f): no upper state:", ray, "z", z));
        }
    }
    CHECK(certain > 10'000);
    CHECK(followed > 5'000);
}

TEST_CASE("L39 (f): the cosine at a contact is bounded, also where it is far less than that at the tangent") {
    Random random(443);
    int followed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double z = half_pi_hi - random.scaled(1e-15, 1e-9);
        const auto at = batch::sin_cos(z);
        const double shift = at.cos * (1 - random.scaled(1e-6, 0.5));
        const double w = at.cos - shift;
        const DoubleRay ray{0, 0, w * w * random.uniform(0.1, 0.9)};
        const auto next = batch::Upper::bounce(z, at, shift, ray.kappa, ray.r);
        const auto exact = after(ray, Real(z) + Real(shift));
        if (next.follows) {
            ++followed;
            if (!exact || !(Real(next.kappa) >= exact->kappa)) {
                FAIL(say("no upper state:", ray, "z", z, "shift", shift));
            }
        }
    }
    CHECK(followed > 10'000);
}

TEMPLATE_TEST_CASE("what was decided by less than a thousandth is not clear", "", batch::Lower,
                   batch::Upper) {
    const auto clear = [](double z, double r) {
        return TestType::bounce(z, batch::sin_cos(z), 0.0, 0.0, r).clear;
    };
    // By the slope of the wall at the contact, and by how much the ray turns back.
    CHECK(clear(half_pi_hi - 0x1.8p-9, 1e-9));
    CHECK_FALSE(clear(half_pi_hi - 0x1.8p-11, 1e-9));
    const double square = std::cos(1.0) * std::cos(1.0);
    CHECK(clear(1, square * (1 - 0x1p-9)));
    CHECK_FALSE(clear(1, square * (1 - 0x1p-11)));
}
