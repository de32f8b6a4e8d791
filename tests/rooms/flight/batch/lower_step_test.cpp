#include "flight/batch/lower_step.hpp"

#include <catch2/catch.hpp>

#include "places.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

TEST_CASE("A close bound of the contact is one, and so is what follows from it, wherever the tangent lies") {
    Random random(411);
    int followed = 0;
    for (int i = 0; i < 60'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        const auto place = some_place(random, ray, some_point(random, ray, exact));
        if (!exact.hits || !place) {
            continue;
        }
        const double z = place->z;
        const auto contact = batch::Lower::contact(*place, ray.c, ray.kappa);
        const Real x = Real(z) + Real(contact.shift);
        if (x < 0 || x > exact.x) {
            FAIL(say("no lower bound:", ray, "z", z, "shift", contact.shift, "x", exact.x));
        }
        if (!contact.close) {
            continue;
        }
        const auto next =
            batch::Lower::bounce(z, place->at, contact.shift, ray.kappa, ray.r * batch::Lower::outward);
        const auto out = reflect<Real>({Real(1), Real(ray.kappa)}, cos(exact.x), Real(ray.r));
        if (next.ends && out.angular < 0) {
            FAIL(say("said to leave, but stays:", ray, "z", z));
        }
        if (next.ends || !next.follows || out.angular >= 0) {
            continue;
        }
        ++followed;
        const Real slope = out.vertical / -out.angular;
        const Real height = sin(exact.x) + slope * (exact.x + pi_in<Real>());
        if (!(Real(next.kappa) <= slope && Real(next.c) <= height && next.c >= 0)) {
            FAIL(say("no lower state:", ray, "z", z, "slope", next.kappa, slope, "height", next.c, height));
        }
    }
    CHECK(followed > 10'000);
}

TEST_CASE("Close bounds are close: within 1e-14 of contact and next state, relative to the angles") {
    Random random(412);
    int close = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        if (!exact.hits || exact.clearance < 1e-3) {
            continue;
        }
        const Real x = close_contact<batch::Lower>(ray, exact);
        ++close;
        const Real incidence = cos(exact.x) - Real(ray.kappa);
        if ((exact.x - x) * incidence > Real(1e-14) * exact.x + Real(1e-299)) {
            FAIL(say("loose:", ray, "x", exact.x, x));
        }
    }
    CHECK(close > 5'000);
}

TEST_CASE("A strict miss is one, wherever the tangent is laid") {
    Random random(413);
    int misses = 0;
    for (int i = 0; i < 40'000; ++i) {
        const DoubleRay ray = random.coin() ? random_ray(random)
                                            : grazing_ray(random.uniform(-1, 0.999),
                                                          random.sign() * random.scaled(1e-17, 1e-3), 1);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        const double z = random.coin() ? exact.x.convert_to<double>() : random.uniform(0, half_pi_hi);
        if (batch::strict_miss(std::min(z, half_pi_hi), batch::sin_cos(std::min(z, half_pi_hi)), ray.c,
                               ray.kappa)) {
            ++misses;
            if (exact.hits) {
                FAIL(say("hits:", ray, "tangent at", z));
            }
        }
    }
    CHECK(misses > 5'000);
}
