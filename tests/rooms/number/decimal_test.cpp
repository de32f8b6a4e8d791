#include "number/decimal.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "random.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

Rational number(const char* text) { return parse_rational(text); }

std::string down(const char* x, int digits) { return to_text(cut_down(number(x), digits)); }
std::string up(const char* x, int digits) { return to_text(cut_up(number(x), digits)); }

// Of any size, with any number of digits.
Rational random_rational(Random& random) {
    Rational x = exact(std::abs(adversarial(random)) + 0x1p-1074);
    return random.coin() ? x : x / Rational(1 + random.below(1000));
}

}  // namespace

TEST_CASE("cut down: the first digits as they are") {
    CHECK(down("2.99999", 3) == "2.99");
    CHECK(down("3", 3) == "3.00");
    CHECK(down("0.00123456", 2) == "0.0012");
    CHECK(down("123456", 6) == "123456");
    CHECK(down("123456", 2) == "1.2e5");
    CHECK(down("123456.789", 7) == "123456.7");
    CHECK(down("2/3", 5) == "0.66666");
    CHECK(down("1/30000", 2) == "3.3e-5");
    CHECK(down("1e3", 1) == "1e3");
    CHECK(down("999", 1) == "9e2");
}

TEST_CASE("cut up: the least decimal that is not below") {
    CHECK(up("2.001", 3) == "2.01");
    CHECK(up("2.01", 3) == "2.01");
    CHECK(up("9.991", 2) == "10");
    CHECK(up("0.0996", 2) == "0.10");
    CHECK(up("1/3", 2) == "0.34");
    CHECK(up("0", 2) == "0");
}

TEST_CASE("decimals are exact, on the right side and nearest, for numbers of all sizes") {
    Random random(61);
    for (int i = 0; i < 2'000; ++i) {
        const Rational x = random_rational(random);
        const int digits = 1 + random.below(60);
        const Decimal below = cut_down(x, digits);
        const Decimal above = cut_up(x, digits);
        CAPTURE(x, digits);
        REQUIRE(static_cast<int>(below.mantissa.str().size()) == digits);
        REQUIRE(static_cast<int>(above.mantissa.str().size()) == digits);
        REQUIRE(exact(below) <= x);
        REQUIRE(x <= exact(above));
        const Rational unit = exact(Decimal{Integer(1), below.exponent});
        REQUIRE(x < exact(below) + unit);
        REQUIRE(exact(above) < x + unit);
    }
}

TEST_CASE("the text is read back as the same number") {
    Random random(62);
    for (int i = 0; i < 1'000; ++i) {
        const Decimal x = cut_down(random_rational(random), 1 + random.below(40));
        if (std::abs(x.exponent) < 900) {
            CAPTURE(to_text(x));
            REQUIRE(parse_rational(to_text(x)) == exact(x));
            REQUIRE(exact(without_zeros(x)) == exact(x));
        }
    }
    CHECK(to_text(without_zeros(cut_down(Rational(1), 15))) == "1");
    CHECK(to_text(without_zeros(cut_down(Rational(21, 2), 9))) == "10.5");
    CHECK(to_text(without_zeros(cut_down(Rational(100), 3))) == "100");
}

TEST_CASE("shared digits: only those of every number of the interval") {
    const auto shared = [](const char* lo, const char* hi, int digits) {
        const auto found = shared_digits(number(lo), number(hi), digits);
        return found ? to_text(*found) : "none";
    };
    CHECK(shared("4.60333", "4.60339", 5) == "4.6033");
    CHECK(shared("4.60333", "4.60339", 6) == "none");
    CHECK(shared("1.9999999", "2", 3) == "none");
    CHECK(shared("1.9999999", "1.99999999", 3) == "1.99");
    CHECK(shared("9.99", "10.01", 1) == "none");
    CHECK(shared("2", "2", 4) == "2.000");
    CHECK(shared("2", "20", 1) == "none");
}

TEST_CASE("digits of 0 or of negative numbers are not asked for") {
    CHECK_THROWS_AS(cut_down(Rational(0), 3), BrokenInvariant);
    CHECK_THROWS_AS(cut_down(Rational(-1), 3), BrokenInvariant);
    CHECK_THROWS_AS(cut_down(Rational(1), 0), BrokenInvariant);
}

TEST_CASE("an exact text is the number, however near it is to another one") {
    const auto text = [](const char* x) { return exact_text(number(x)); };
    CHECK(text("4.603338848751700") == "4.6033388487517");
    CHECK(text("4.603338848751701") == "4.603338848751701");
    CHECK(text("1.000000000000000000000000000000000000000000000000001") ==
          "1.000000000000000000000000000000000000000000000000001");
    CHECK(text("33/8") == "4.125");
    CHECK(text("10/3") == "10/3");
    CHECK(text("1000000") == "1000000");
    CHECK(text("1e300") == "1e300");
    CHECK(text("12345678901234567890") == "12345678901234567890");
    CHECK(text("1e-30") == "1e-30");
    // A decimal of 61 digits.
    CHECK(text("2305843009213693953/2305843009213693952") == "2305843009213693953/2305843009213693952");
    CHECK_THROWS_AS(exact_text(Rational(0)), BrokenInvariant);

    Random random(64);
    for (int i = 0; i < 2'000; ++i) {
        const Rational x = random_rational(random);
        CAPTURE(x);
        // Beyond 2,100 characters or exponents of 1,000 parse_rational refuses what it is given.
        if (const std::string shown = exact_text(x); shown.size() <= 1000) {
            REQUIRE(parse_rational(shown) == x);
        }
    }
}
