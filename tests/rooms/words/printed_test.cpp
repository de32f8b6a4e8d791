#include "words/printed.hpp"

#include <fmt/core.h>

#include <cmath>
#include <random>

#include "catch.hpp"
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
        const std::string power = "1" + fmt::format("{:.16e}", x).substr(18);  // 1e-05 for 3.2...e-05
        CHECK(up - down == parse_rational(power) / Rational(100));
    }
}

TEST_CASE("three digits are the nearest of those that are not below, or not above, also of an exact number") {
    CHECK(rounded_up(parse_rational("43e-41")) == "4.3e-40");  // its double is above
    CHECK(rounded_up(parse_rational("43e-41") + parse_rational("1e-300")) == "4.31e-40");
    CHECK(rounded_up(4.3002e-5) == "4.31e-05");
    CHECK(rounded_down(4.3099e-5) == "4.3e-05");
    CHECK(rounded_up(9.991) == "10");
    CHECK(rounded_up(999.1) == "1e+03");
    CHECK(rounded_down(1000) == "1e+03");
    CHECK(rounded_down(0.00099999) == "0.000999");
    CHECK(rounded_down(0x1.fffffffffffffp-1) == "0.999");
    CHECK(rounded_up(0x1p-1074) == "4.95e-324");
    CHECK(rounded_up(0.0) == "0");
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
