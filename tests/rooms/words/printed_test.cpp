#include "words/printed.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "number/rational.hpp"

using namespace dumbbell;

TEST_CASE("three digits are never below, or never above, the number they stand for") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> digits(1, 10);
    std::uniform_int_distribution<int> exponent(-40, 40);
    for (int i = 0; i < 10'000; ++i) {
        const double x = digits(random) * std::pow(10, exponent(random));
        CAPTURE(x);
        const Rational up = parse_rational(rounded_up(x));
        const Rational down = parse_rational(rounded_down(x));
        CHECK((up >= exact(x) && down <= exact(x)));
        CHECK(up - down <= exact(x) * Rational(2, 100));
    }
}

TEST_CASE("numbers of three digits are printed as they are") {
    CHECK(rounded_up(0.25) == "0.25");
    CHECK(rounded_down(0.25) == "0.25");
    CHECK(rounded_up(1.25) == "1.25");
}

TEST_CASE("zero is printed without a sign, every other number as it is") {
    CHECK_FALSE(std::signbit(unsigned_zero(-0.0)));
    for (const double x : {1.0, -1.0, -0x1p-1074, 1e300}) {
        CHECK(unsigned_zero(x) == x);
    }
}
