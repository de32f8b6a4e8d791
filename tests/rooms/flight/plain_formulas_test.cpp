// The formulas of plain interval evaluation (lemma L16), each over random boxes against exact values.
#include "catch.hpp"
#include "departures.hpp"
#include "flight/plain.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// x, and a neighbour of it, as an interval.
template <class I>
I around(Random& random, double x, double widest, double most) {
    const double other = random.coin() ? x : x + std::abs(x) * random.scaled(1e-16, widest);
    return {std::min(x, most), std::min(other, most)};
}

double pick(Random& random, const Interval& x) { return Span{x.lo(), x.hi()}.sample(random); }

}  // namespace

TEST_CASE("The plain count of rays to the light walls bounds the true number of rays in boxes") {
    Random random(225);
    const long rays = scaled(5'000);
    int met = 0;
    for (int i = 0; i < rays; ++i) {
        const dumbbell_test::DoubleRay ray = random_ray(random, 1e-2);
        const double widest = random.coin() ? 1e-9 : 0.3;
        const auto c = around<Interval>(random, ray.c, widest, 10);
        const auto kappa = around<Interval>(random, ray.kappa, widest, 1);
        const auto r = around<Interval>(random, ray.r, widest, 1);
        if (!(kappa.lo() >= -r.lo())) {
            continue;  // not a ray of L4
        }
        const dumbbell_test::DoubleRay state{pick(random, c), pick(random, kappa), pick(random, r)};
        const long most = plain_count(dumbbell::flight::PlainRay<Interval>{c, kappa},
                                      flight::Body<Interval>::massless(r), plain_cap);
        const long exact = ray_count<Real>(state, plain_cap).hits;
        if (exact > most) {
            FAIL(say(state, "has", exact, "collisions, the bound is", most, "for", c, kappa, r));
        }
        met += exact == most ? 1 : 0;
    }
    CHECK(met > rays * 3 / 5);
}

TEST_CASE("The plain contact encloses the contact of every ray of a box that collides") {
    Random random(226);
    int collided = 0;
    for (int i = 0; i < 10'000; ++i) {
        const dumbbell_test::DoubleRay ray = random_ray(random);
        const auto c = around<Interval>(random, ray.c, 0.1, 10);
        const auto kappa = around<Interval>(random, ray.kappa, 0.1, 1);
        const auto at = flight::detail::plain_contact(dumbbell::flight::PlainRay<Interval>{c, kappa});
        const auto exact = exact_flight<Real>(Real(pick(random, c)), Real(pick(random, kappa)));
        if (!exact.hits || abs(exact.clearance) < Real(1e-50)) {
            continue;
        }
        ++collided;
        REQUIRE(at.has_value());
        const Real tolerance("1e-40");  // of the reference's root
        const bool enclosed = low_at_most(at->x, Real(exact.x * (1 + tolerance))) &&
                              high_at_least(at->x, Real(exact.x * (1 - tolerance))) &&
                              low_at_most(at->sin_x, Real(sin(exact.x) * (1 + tolerance))) &&
                              high_at_least(at->sin_x, Real(sin(exact.x) * (1 - tolerance))) &&
                              low_at_most(at->cos_x, Real(cos(exact.x) * (1 + tolerance))) &&
                              high_at_least(at->cos_x, Real(cos(exact.x) * (1 - tolerance)));
        if (!enclosed) {
            FAIL(say("contact", exact.x, "of", c, kappa, "not in", at->x, at->sin_x, at->cos_x));
        }
    }
    CHECK(collided > 4000);
}

TEST_CASE("The plain reflected slope encloses every slope below 1, near denominators of 0 too") {
    Random random(227);
    int enclosed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double r_mid = random_r(random);
        const double w_mid = random.coin() ? random.uniform(0, 1) : random.scaled(1e-9, 1);
        // The slope before it for a wanted slope after it; D = 0 where that is infinite.
        const double a = (w_mid - r_mid / w_mid) / 2;
        const double wanted = random.coin() ? random.uniform(0, 1.1) : random.scaled(0.1, 1e12);
        const double kappa_mid = a - (a * a + r_mid) / (wanted + a);
        const auto r = around<Interval>(random, r_mid, 0.1, 1);
        const auto w = around<Interval>(random, w_mid, 0.1, 1);
        const auto kappa = around<Interval>(random, kappa_mid, 0.1, 1);
        bool undecided = false;
        const Interval ours = flight::detail::reflected_slope(flight::reflect_at_light_wall(kappa, w, r),
                                                              kappa, w, r, undecided);
        const Real k(pick(random, kappa));
        const auto out = reflect<Real>({Real(1), k}, Real(pick(random, w)), Real(pick(random, r)));
        if (undecided || !(out.angular < 0)) {
            continue;
        }
        const Real slope = out.vertical / -out.angular;
        if (slope < 1) {
            ++enclosed;
            if (!encloses(ours, slope)) {
                FAIL(say("slope", slope, "not in", ours, "for", kappa, w, r));
            }
        }
    }
    CHECK(enclosed > 3500);
}

TEST_CASE(
    "A slope whose denominator may be 0 is bounded from below if its numerator is positive, or undecided") {
    bool undecided = false;
    const Interval bounded = flight::detail::slope_of(Interval(0.1, 0.2), Interval(-1, 0.5), undecided);
    CHECK_FALSE(undecided);
    CHECK(bounded.lo() <= 0.2);
    CHECK(bounded.lo() > 0.199);
    CHECK(bounded.hi() >= 1);
    flight::detail::slope_of(Interval(-0.1, 0.2), Interval(-1, 0.5), undecided);
    CHECK(undecided);
    undecided = false;
    flight::detail::slope_of(Interval(not_a_number), Interval(-1, 0.5), undecided);
    CHECK(undecided);
}
