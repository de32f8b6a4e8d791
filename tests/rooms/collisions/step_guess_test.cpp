#include "collisions/step_guess.hpp"

#include <cmath>

#include "catch.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

TEST_CASE("q_c(3) is 1") { CHECK(guess_step(3) == Approx(1).epsilon(1e-15)); }

TEST_CASE("q_c(4) is sqrt(1 + x^2) for the first positive root of tan x = x") {
    Real x = 4.4934;
    for (int i = 0; i < 20; ++i) {
        x -= (sin(x) - x * cos(x)) / (x * sin(x));
    }
    const Real root = sqrt(1 + x * x);
    CHECK(abs(real(critical_ratio(4)) - root) < Real("1e-58"));
    CHECK(std::abs(guess_step(4) - root.convert_to<double>()) < 1e-14);
}

TEST_CASE("the maximum, recomputed in 80 digits, steps up within 1e-12 of each guess") {
    for (const long n :
         {4L, 5L, 6L, 7L, 8L, 9L, 10L, 11L, 12L, 13L, 14L, 15L, 16L, 50L, 99L, 100L, 300L, 887L}) {
        CAPTURE(n);
        const Rational guess = exact(guess_step(n));
        CHECK(reference_maximum(guess * (1 - parse_rational("1e-12"))) == n - 1);
        CHECK(reference_maximum(guess * (1 + parse_rational("1e-12"))) == n);
    }
}

TEST_CASE("the guesses increase") {
    double last = 1;
    for (long n = 4; n < 300; ++n) {
        const double next = guess_step(n);
        CAPTURE(n);
        REQUIRE(next > last);
        last = next;
    }
}

TEST_CASE("a step of short orbits is as near to the true one as it was asked for") {
    for (const long n : steps({4, 5, 34}, {6, 33, 1000})) {
        for (const int share_bits : {24, 53, 120, 150}) {
            CAPTURE(n, share_bits);
            const auto step = find_step(n, share_bits);
            REQUIRE(step);
            CHECK(step->below < critical_ratio(n));
            CHECK(critical_ratio(n) < step->above);
            const Rational width = (step->above - step->below) * (n - 2) * (Integer(1) << (share_bits - 7));
            CHECK((width > step->at / 2 && width < 2 * step->at));
        }
    }
}

TEST_CASE("so is one of orbits that are followed by macro steps") {
    const Rational critical = at("1275051786969.07530004702");  // `critical 1000000 --digits 24`
    for (const int share_bits : {24, 40}) {
        const auto step = find_step(1'000'000, share_bits);
        REQUIRE(step);
        CHECK((step->below < critical && critical < step->above));
    }
    CHECK_FALSE(find_step(1'000'000, 24, [] { return true; }));
}
