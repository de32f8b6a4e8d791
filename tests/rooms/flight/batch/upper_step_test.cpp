#include "flight/batch/upper_step.hpp"

#include <catch2/catch.hpp>

#include "places.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

TEST_CASE(
    "A close upper bound of the contact is one, and so is what follows from it, wherever the tangent lies") {
    Random random(431);
    int followed = 0;
    for (int i = 0; i < 60'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        const auto place = some_place(random, ray, some_point(random, ray, exact));
        if (!place) {
            continue;
        }
        const double z = place->z;
        const auto contact = batch::Upper::contact(*place, ray.c, ray.kappa);
        if (!contact.close) {
            continue;
        }
        const Real x = Real(z) + Real(contact.shift);
        if (!exact.hits || x < exact.x || x > pi_in<Real>() / 2) {
            FAIL(say("no upper bound:", ray, "z", z, "shift", contact.shift, "x", exact.x));
        }
        const auto next =
            batch::Upper::bounce(z, place->at, contact.shift, ray.kappa, ray.r * batch::Upper::outward);
        const auto out = reflect<Real>({Real(1), Real(ray.kappa)}, cos(exact.x), Real(ray.r));
        if (next.ends) {
            continue;
        }
        ++followed;
        const Real slope = out.vertical / -out.angular;
        const Real height = sin(exact.x) + slope * (exact.x + pi_in<Real>());
        if (!(out.angular < 0 && Real(next.kappa) >= slope && Real(next.c) >= height)) {
            FAIL(say("no upper state:", ray, "z", z, "slope", next.kappa, slope, "height", next.c, height));
        }
    }
    CHECK(followed > 10'000);
}

TEST_CASE("Close upper bounds are close: within 1e-13 of the contact, relative to the angle of incidence") {
    Random random(432);
    int close = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        if (!exact.hits || exact.clearance < 1e-3) {
            continue;
        }
        const Real x = close_contact<batch::Upper>(ray, exact);
        ++close;
        if ((x - exact.x) * (cos(exact.x) - Real(ray.kappa)) > Real(1e-13) * exact.x + Real(1e-269)) {
            FAIL(say("loose:", ray, "x", exact.x, x));
        }
    }
    CHECK(close > 5'000);
}
