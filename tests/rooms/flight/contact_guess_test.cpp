// Guesses prove nothing, but bad ones would cost decisions: they are held to be good.
#include "flight/contact_guess.hpp"

#include "catch.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

TEST_CASE("Away from tangency the guess in doubles is right about hit or miss and near the root") {
    Random random(121);
    for (int i = 0; i < 10'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        const auto guess = guess_contact(Interval(ray.c), Interval(ray.kappa));
        const double z = guess.z.lo();
        if (!(z >= 0 && z <= half_pi<Interval>().lo() && guess.z.hi() == z)) {
            FAIL(say(ray, "guess", guess.z, "is outside of [0, pi/2] or not thin"));
        }
        if (abs(exact.clearance) < 1e-10) {
            continue;
        }
        const Real steepness = exact.hits ? Real(cos(exact.x) - ray.kappa) : Real(sin(exact.x));
        if (guess.hits != exact.hits || abs(z - exact.x) * steepness > 1e-14) {
            FAIL(say(ray, "guess", guess.z, guess.hits, "exact", exact.x, exact.hits));
        }
    }
}

TEST_CASE("In multiple precision the guess uses the bits it is given") {
    Random random(122);
    for (const int bits : {64, 128, 256, 500}) {
        const PrecisionScope scope(bits);
        for (int i = 0; i < 400; ++i) {
            const DoubleRay ray = random_ray(random);
            const auto exact = exact_flight(Decimal<200>(ray.c), Decimal<200>(ray.kappa));
            if (abs(exact.clearance) < 1e-14) {
                continue;
            }
            const auto guess = guess_contact(BigInterval(ray.c), BigInterval(ray.kappa));
            const auto z = low_of<Decimal<200>>(guess.z);
            const Decimal<200> steepness =
                exact.hits ? Decimal<200>(cos(exact.x) - ray.kappa) : Decimal<200>(sin(exact.x));
            const Decimal<200> error = abs(z - exact.x) * steepness;
            if (guess.hits != exact.hits || (exact.clearance > 1e-4 && error > std::ldexp(1.0, 8 - bits)) ||
                (exact.hits && 4 * abs(z - exact.x) > steepness)) {  // nearer to the other root
                FAIL(
                    say(ray, "bits", bits, "hits", guess.hits, exact.hits, "exact", exact.x, "error", error));
            }
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
