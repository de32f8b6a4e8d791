#include "flight/contact.hpp"

#include "catch.hpp"
#include "rays.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

/// Fails unless both contacts bound what `flight` finds in T.
template <class I, class T>
void check_bounds(const DoubleRay& ray) {
    const auto exact = exact_flight(T(ray.c), T(ray.kappa));
    const auto lowest = lowest_contact(I(ray.c), I(ray.kappa));
    const auto highest = highest_contact(I(ray.c), I(ray.kappa));
    if (!lowest && exact.hits) {
        FAIL(say("certain to miss, but hits:", ray));
    }
    if (highest && !exact.hits) {
        FAIL(say("certain to hit, but misses:", ray));
    }
    if (lowest && exact.hits &&
        !(high_at_least(lowest->cos_x, T(cos(exact.x))) && low_at_most(lowest->x, exact.x) &&
          low_at_most(lowest->sin_x, T(sin(exact.x))))) {
        FAIL(say("no lower bound:", ray, "x", lowest->x, "exact", exact.x));
    }
    if (highest && !(low_at_most(highest->cos_x, T(cos(exact.x))) && high_at_least(highest->x, exact.x) &&
                     high_at_least(highest->sin_x, T(sin(exact.x))))) {
        FAIL(say("no upper bound:", ray, "x", highest->x, "exact", exact.x));
    }
}

bool is_thin(const Contact<Interval>& contact) {
    return contact.x.lo() == contact.x.hi() && contact.sin_x.lo() == contact.sin_x.hi() &&
           contact.cos_x.lo() == contact.cos_x.hi();
}

}  // namespace

TEST_CASE("The lowest and the highest contact bound the root for rays of all kinds") {
    Random random(101);
    for (int i = 0; i < scaled(6'000); ++i) {
        check_bounds<Interval, Real>(random_ray(random));
    }
}

TEST_CASE("They bound the root in multiple precision too, from 53 to 512 bits") {
    Random random(102);
    for (const int bits : {53, 80, 128, 256, 512}) {
        const PrecisionScope scope(bits);
        for (int i = 0; i < scaled(250); ++i) {
            check_bounds<BigInterval, Decimal<200>>(random_ray(random));
        }
    }
}

TEST_CASE("They bound the root with 6 to 40 bits, where a bound rounded to the wrong side shows") {
    Random random(108);
    for (int i = 0; i < 6'000; ++i) {
        const PrecisionScope scope(6 + random.below(35));
        DoubleRay ray = random_ray(random);
        // The ray in so few bits, exactly.
        ray.c = BigInterval(ray.c).lo();
        ray.kappa = BigInterval(ray.kappa).lo();
        check_bounds<BigInterval, Real>(ray);
    }
}

TEST_CASE(
    "Grazing rays at margins of 1e-3 to 1e-17 on both sides are never misjudged, clear ones are decided") {
    Random random(103);
    for (int digits = 3; digits <= 17; ++digits) {
        for (int i = 0; i < 60; ++i) {
            for (const double sign : {-1.0, 1.0}) {
                const auto ray = grazing_ray(random.uniform(-1, 0.95), sign * std::pow(10.0, -digits), 1);
                check_bounds<Interval, Real>(ray);
                const PrecisionScope scope(200);
                check_bounds<BigInterval, Decimal<100>>(ray);
                const bool misses = !lowest_contact(Interval(ray.c), Interval(ray.kappa));
                const bool hits = highest_contact(Interval(ray.c), Interval(ray.kappa)).has_value();
                if (digits <= 11 && (sign > 0 ? !misses : !hits)) {
                    FAIL(say("undecided at 10 to the minus", digits, ray));
                }
                const bool misses_big = !lowest_contact(BigInterval(ray.c), BigInterval(ray.kappa));
                const bool hits_big = highest_contact(BigInterval(ray.c), BigInterval(ray.kappa)).has_value();
                if (digits <= 14 && (sign > 0 ? !misses_big : !hits_big)) {
                    FAIL(say("undecided with 200 bits at 10 to the minus", digits, ray));
                }
            }
        }
    }
}

TEST_CASE("Away from tangency both bounds are within 1e-14 of the root, relative to the angle of incidence") {
    Random random(104);
    double worst = 0;
    for (int i = 0; i < 5'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        if (!exact.hits || exact.clearance < 1e-6) {
            continue;
        }
        const auto lowest = lowest_contact(Interval(ray.c), Interval(ray.kappa));
        const auto highest = highest_contact(Interval(ray.c), Interval(ray.kappa));
        if (!lowest || !highest) {
            FAIL(say("undecided:", ray));
        }
        if (!is_thin(*lowest) || !is_thin(*highest)) {
            FAIL(say("not thin:", ray));
        }
        const double incidence = (cos(exact.x) - ray.kappa).convert_to<double>();
        const double spread = (highest->x.hi() - lowest->x.lo()) * incidence;
        worst = std::max(worst, spread);
        if (!(spread < 1e-14)) {
            FAIL(say("loose:", ray, "from", lowest->x, "to", highest->x));
        }
    }
    WARN("greatest spread times incidence: " << worst);
}

TEST_CASE("In multiple precision both bounds are as close as the working precision, beyond 2^-1000 too") {
    for (const int bits : {128, 1000, 1024, 1500, 2048, 4096}) {
        const PrecisionScope scope(bits);
        for (const DoubleRay& ray : {DoubleRay{0.1, 0.2, 0.1}, {0.5, 0.01, 0.01}, {0.25, -0.5, 1}}) {
            INFO(bits << " bits, " << show(ray));
            const auto lowest = lowest_contact(BigInterval(ray.c), BigInterval(ray.kappa));
            const auto highest = highest_contact(BigInterval(ray.c), BigInterval(ray.kappa));
            REQUIRE((lowest && highest));
            CHECK(certainly_at_most(lowest->x, highest->x));
            CHECK(certainly_less(highest->x - lowest->x, power_of_half(bits - 12)));
        }
    }
}

TEST_CASE("A lower bound holds for all rays above, an upper bound for all rays below") {
    Random random(105);
    for (int i = 0; i < 10'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto lowest = lowest_contact(Interval(ray.c), Interval(ray.kappa));
        const auto highest = highest_contact(Interval(ray.c), Interval(ray.kappa));
        const double up_c = ray.c + (random.coin() ? 0 : random.scaled(1e-18, 1));
        const double up_kappa =
            std::min(0x1.fffffffffffffp-1, ray.kappa + (random.coin() ? 0 : random.scaled(1e-18, 0.5)));
        const auto above = exact_flight(Real(up_c), Real(up_kappa));
        if (above.hits && (!lowest || !low_at_most(lowest->x, above.x))) {
            FAIL(say("ray", ray, "above it", up_c, up_kappa));
        }
        if (highest) {
            const auto below = exact_flight(Real(ray.c * random.uniform(0, 1)),
                                            Real(ray.kappa - random.scaled(1e-18, 1e-3)));
            if (!below.hits || !high_at_least(highest->x, below.x)) {
                FAIL(say("below", ray, "misses, or hits higher"));
            }
        }
    }
}

TEST_CASE("A strict miss is one, wherever the tangent is laid") {
    Random random(106);
    int misses = 0;
    for (int i = 0; i < 10'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const Interval c(ray.c);
        const Interval kappa(ray.kappa);
        const Interval z(random.uniform(0, 0x1.921fb54442d18p+0));
        if (flight::detail::strict_miss(flight::detail::tangent_at(z, c, kappa), c, kappa)) {
            ++misses;
            if (exact_flight(Real(ray.c), Real(ray.kappa)).hits) {
                FAIL(say("hits:", ray, "tangent at", z));
            }
        }
    }
    CHECK(misses > 500);
}

TEST_CASE("Sine and cosine are enclosed near the point of the tangent, and far from it") {
    Random random(107);
    for (int i = 0; i < 10'000; ++i) {
        const double z = random.uniform(0, 0x1.921fb54442d18p+0);
        const double x = random.coin() ? random.uniform(0, 0x1.921fb54442d18p+0)
                                       : std::max(0.0, z + random.sign() * random.scaled(1e-18, 1e-3));
        const auto at = flight::detail::shifted(
            flight::detail::tangent_at(Interval(z), Interval(0), Interval(0)), Interval(x));
        if (!encloses(at.sin, Real(sin(Real(x)))) || !encloses(at.cos, Real(cos(Real(x))))) {
            FAIL(say("from z", z, "to x", x, "sin", at.sin, "cos", at.cos));
        }
    }
}

TEST_CASE("A ray through the corner itself hits there, in both bounds") {
    for (const double kappa : {-0.5, 0.0, 0.25, 0.9}) {
        CAPTURE(kappa);
        const auto lowest = lowest_contact(Interval(0), Interval(kappa));
        const auto highest = highest_contact(Interval(0), Interval(kappa));
        REQUIRE((lowest && highest));
        CHECK(lowest->x.lo() <= 0);
        CHECK(highest->x.hi() > 0);  // L12 (b) wants a step beyond the root
        CHECK(highest->x.hi() < 1e-15);
    }
}

TEST_CASE("A ray that passes the peak by a hair is a miss, one that meets it by a hair a hit") {
    CHECK_FALSE(lowest_contact(Interval(1.000001), Interval(0)));
    CHECK(highest_contact(Interval(0.999999), Interval(0)));
    CHECK(lowest_contact(Interval(1),
                         Interval(0)));  // horizontal, at the peak's height: undecidable in doubles
    CHECK_FALSE(highest_contact(Interval(1), Interval(0)));
    CHECK_FALSE(lowest_contact(Interval(2), Interval(-0.5)));
    CHECK_FALSE(lowest_contact(Interval(1e10), Interval(0.5)));
}

TEMPLATE_TEST_CASE("NaN is neither a certain miss nor a certain hit", "", Interval, BigInterval) {
    using I = TestType;
    const I bad(not_a_number);
    for (const I& c : {bad, I(0.1)}) {
        for (const I& kappa : {bad, I(0.2), I(-0.2)}) {
            const bool has_nan = std::isnan(approximate(c)) || std::isnan(approximate(kappa));
            CAPTURE(show(c), show(kappa));
            CHECK((!has_nan || lowest_contact(c, kappa).has_value()));
            CHECK((!has_nan || !highest_contact(c, kappa).has_value()));
        }
    }
}

TEST_CASE("A guess from NaN or from absurd rays stays in [0, pi/2]") {
    for (const double c : {not_a_number, 0.0, 1e300, infinity, -1.0}) {
        for (const double kappa : {not_a_number, 1.0, 1.5, 1e300, -infinity, infinity, -1e5}) {
            const auto guess = guess_contact(Interval(c), Interval(kappa));
            CAPTURE(c, kappa, show(guess.z));
            CHECK(guess.z.lo() >= 0);
            CHECK(guess.z.hi() <= half_pi<Interval>().lo());
        }
    }
}
