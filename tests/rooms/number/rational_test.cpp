#include "number/rational.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "catch.hpp"
#include "random.hpp"
#include "show.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// Why a text is refused; "accepted" if it is not.
std::string refusal(
    std::string_view text,
    Rational (*parse)(std::string_view) = [](std::string_view number) { return parse_rational(number); }) {
    try {
        static_cast<void>(parse(text));
    } catch (const InputError& refused) {
        return refused.what();
    }
    return "accepted";
}

Rational power_of_ten(unsigned n) { return {pow(Integer(10), n)}; }

}  // namespace

TEST_CASE("All spellings of a number give the same rational") {
    for (const char* text : {"9/2", "4.5", "45e-1", "0.45e1", "4.50", "04.5", "18/4", "450E-2", "0.045e+2",
                             "09/02", "4500000e-006", "4.5e0", "4.5E00"}) {
        CAPTURE(text);
        CHECK(parse_rational(text) == Rational(9, 2));
        CHECK(to_fraction(parse_rational(text)) == "9/2");
    }
    CHECK(parse_rational("1e6") == 1'000'000);
    CHECK(parse_rational("10^6") == 1'000'000);
    CHECK(parse_rational("10^-2") == Rational(1, 100));
    CHECK(parse_rational("1E+3") == 1000);
    CHECK(parse_rational("1.0000001") == Rational(10'000'001, 10'000'000));
    CHECK(parse_rational("0") == 0);
    CHECK(parse_rational("0/7") == 0);
    CHECK(parse_rational("0.000e5") == 0);
}

TEST_CASE("Leading zeros are decimal, not octal") {
    CHECK(parse_rational("0010") == 10);
    CHECK(parse_rational("00.50") == Rational(1, 2));
    CHECK(parse_rational("010/07") == Rational(10, 7));
    CHECK(parse_rational("089") == 89);
    CHECK(parse_rational("1e010") == power_of_ten(10));
    CHECK(parse_rational("0.010") == Rational(1, 100));
}

TEST_CASE("Exponents up to 1000 and texts up to 2100 characters are taken") {
    CHECK(parse_rational("1e1000") == power_of_ten(1000));
    CHECK(parse_rational("1e-1000") == 1 / power_of_ten(1000));
    CHECK(parse_rational("1e+0001000") == power_of_ten(1000));
    CHECK(parse_rational("1.25e-1000") == Rational(5, 4) / power_of_ten(1000));
    const std::string nines(2100, '9');
    CHECK(parse_rational(nines) == power_of_ten(2100) - 1);
    CHECK(parse_rational("0." + std::string(997, '0') + "1") == 1 / power_of_ten(998));
    CHECK(parse_rational("1e" + std::string(994, '0') + "1000") == power_of_ten(1000));
}

TEST_CASE("Anything else is refused, and the message names the text") {
    for (const char* text :
         {"",      " ",     "1 ",    " 1",    "+1",    "-x",    "1.",       ".5",       ".",    "1e",
          "1e+",   "1e-",   "e5",    "1/2/3", "1/",    "/2",    "/",        "1/-2",     "1/+2", "-1/",
          "1.5/2", "1/2.5", "1/2e3", "1e3/2", "0x10",  "0b1",   "1e0x5",    "inf",      "nan",  "NaN",
          "INF",   "one",   "1,5",   "1'000", "1_000", "1e1.5", "1e5 ",     "1e 5",     "1 /2", "1/ 2",
          "1..5",  "1.5.2", "1ee5",  "1e5e5", "1f",    "1.5d0", "10%",      "1:2",      "1\n",  "\t1",
          "5:3",   "--1",   "1e--5", "1e+-5", "0x1p3", "1e5L",  "\xc2\xbd", "\xd9\xa1", "²",    "1;2"}) {
        CAPTURE(text);
        CHECK_THAT(refusal(text), Contains("is not a number"));
    }
    CHECK_THAT(refusal(std::string_view("1\0", 2)), Contains("is not a number"));
    CHECK_THAT(refusal(std::string_view("1\0002", 3)), Contains("is not a number"));
    CHECK_THAT(refusal("abc"), Contains("'abc'"));
    for (const char* text : {"-1", "-1/2", "-1e-6", "-4.5"}) {
        CHECK_THAT(refusal(text), Contains("is negative: write a positive number"));
    }
    for (const auto& [text, likely] : {std::pair{"+10", "10"},
                                       {".5", "0.5"},
                                       {"10.", "10"},
                                       {"+.5", "0.5"},
                                       {"4,61", "4.61"},
                                       {"10..20", "10:20"},
                                       {"1/2...3", "1/2:3"},
                                       {"10-20", "10:20"},
                                       {"10\u201320", "10:20"}}) {
        CHECK_THAT(refusal(text), EndsWith(std::string("is not a number: write ") + likely));
    }
    CHECK_THAT(refusal("\u22124.5"), Contains("'\u22124.5' is negative: write a positive number"));
    // The last one took longer with each sign, without end, where a guess of what is meant made guesses
    // itself.
    for (const std::string text :
         {".", "+", "-", "++1", "..5", "1,000", "1,2,3", "-----------------0/x....................."}) {
        CHECK_THAT(refusal(text), EndsWith("write it like 10, 4.6, 1e6 or 9/2"));
    }
}

TEST_CASE("Zero denominators, absurd exponents and over-long texts are refused for what they are") {
    CHECK_THAT(refusal("1/0"), Contains("divides by zero"));
    CHECK_THAT(refusal("0/0"), Contains("divides by zero"));
    CHECK_THAT(refusal("5/000"), Contains("divides by zero"));
    CHECK_THAT(refusal("1e1001"), Contains("exponent"));
    CHECK_THAT(refusal("1e-1001"), Contains("exponent"));
    CHECK_THAT(refusal("1e999999999999999999999999999"), Contains("exponent"));
    CHECK_THAT(refusal("1e" + std::string(990, '9')), Contains("exponent"));
    CHECK_THAT(refusal("1e2147483648"), Contains("exponent"));
    CHECK_THAT(refusal("1e4294967297"), Contains("exponent"));
    CHECK_THAT(refusal(std::string(2101, '1')), Contains("too long"));
    CHECK_THAT(refusal(std::string(2101, 'x')), Contains("too long"));
    CHECK_THAT(refusal(std::string(1'000'000, '1')), Contains("too long"));
}

TEST_CASE("A message stays short and printable whatever the text holds") {
    const std::string message = refusal("\x1b[31m\n\x07" + std::string(900, 'z'));
    CHECK(message.size() < 200);
    for (const char c : message) {
        CHECK((c >= ' ' && c <= '~'));
    }
}

TEST_CASE("Numbers are read exactly: value times power of ten") {
    Random random(51);
    for (int i = 0; i < 2000; ++i) {
        const auto whole = random.bits() >> random.below(64);
        const auto exponent = static_cast<unsigned>(random.below(300));
        const std::string digits = std::to_string(whole);
        if (parse_rational(digits + "e" + std::to_string(exponent)) !=
                Rational(Integer(whole)) * power_of_ten(exponent) ||
            parse_rational(digits + "e-" + std::to_string(exponent)) !=
                Rational(Integer(whole)) / power_of_ten(exponent)) {
            FAIL(say("digits", digits, "exponent", exponent));
        }
        const auto cut = static_cast<std::size_t>(1 + random.below(static_cast<int>(digits.size())));
        const std::string point =
            cut < digits.size() ? digits.substr(0, cut) + "." + digits.substr(cut) : digits;
        if (parse_rational(point) !=
            Rational(Integer(whole)) / power_of_ten(static_cast<unsigned>(digits.size() - cut))) {
            FAIL(say("decimal", point));
        }
    }
}

TEST_CASE("to_fraction is in lowest terms, with a denominator always") {
    CHECK(to_fraction(Rational(10)) == "10/1");
    CHECK(to_fraction(Rational(6, 4)) == "3/2");
    CHECK(to_fraction(Rational(0)) == "0/1");
    CHECK(to_fraction(parse_rational("1e-3")) == "1/1000");
    for (const char* text : {"9/2", "1/1000000007", "123456789123456789123456789/2"}) {
        CHECK(to_fraction(parse_rational(text)) == text);
    }
}

TEST_CASE("to_decimal rounds to nearest with the digits asked for") {
    CHECK(to_decimal(Rational(2, 3), 6) == "0.666667");
    CHECK(to_decimal(Rational(9, 2), 6) == "4.5");
    CHECK(to_decimal(parse_rational("4.603339"), 6) == "4.60334");
    CHECK(to_decimal(Rational(10), 6) == "10");
    CHECK(to_decimal(parse_rational("1e6"), 6) == "1e+06");
    CHECK(to_decimal(parse_rational("1e6"), 8) == "1000000");
    CHECK(to_decimal(parse_rational("1e1000"), 3) == "1e+1000");
    CHECK(to_decimal(parse_rational("1.000000000000000000000001"), 25) == "1.000000000000000000000001");
}

TEST_CASE("enclose gives the tightest interval in double") {
    Random random(52);
    for (int i = 0; i < 20'000; ++i) {
        const double d = adversarial(random);
        const int shift = random.below(3) - 1;
        // d moved by a hair: just above, on, or just below a double.
        const Rational x = exact(d) + shift * exact(0x1p-1074) / 3;
        const Interval ours = enclose<Interval>(x);
        const bool tightest = shift == 0  ? ours.lo() == d && ours.hi() == d
                              : shift > 0 ? ours.lo() == d && ours.hi() == next_up(d)
                                          : ours.lo() == next_down(d) && ours.hi() == d;
        if (!tightest) {
            FAIL(say("d =", d, "shift", shift, "enclosed by", ours));
        }
    }
    const Interval third = enclose<Interval>(Rational(1, 3));
    CHECK(third.hi() == next_up(third.lo()));
    CHECK((exact(third.lo()) < Rational(1, 3) && Rational(1, 3) < exact(third.hi())));
}

TEST_CASE("enclose holds numbers beyond the range of double") {
    const Rational huge = parse_rational("1e400");
    CHECK(enclose<Interval>(huge).lo() == greatest);
    CHECK(enclose<Interval>(huge).hi() == infinity);
    CHECK(enclose<Interval>(-huge).lo() == -infinity);
    CHECK(enclose<Interval>(-huge).hi() == -greatest);
    CHECK(enclose<Interval>(1 / huge).lo() == 0);
    CHECK(enclose<Interval>(1 / huge).hi() == 0x1p-1074);
    CHECK(enclose<Interval>(-1 / huge).lo() == -0x1p-1074);
    CHECK(enclose<Interval>(-1 / huge).hi() == 0);
}

TEST_CASE("enclose in multiple precision is as tight as the working precision") {
    const PrecisionScope scope(200);
    const BigInterval third = enclose<BigInterval>(Rational(1, 3));
    CHECK(width(third) <= 0x1p-201);
    CHECK_FALSE(certainly_less(third * BigInterval(3), BigInterval(1)));
    CHECK_FALSE(certainly_less(BigInterval(1), third * BigInterval(3)));
    CHECK(width(enclose<BigInterval>(Rational(9, 2))) == 0);
    CHECK(PrecisionScope::current() == 200);
}

TEST_CASE("exact is the double's own value, and refuses what has none") {
    CHECK(exact(0.5) == Rational(1, 2));
    CHECK(exact(-0.0) == 0);
    CHECK(exact(0.1) != Rational(1, 10));
    CHECK(exact(0.1) == Rational(Integer("3602879701896397"), Integer("36028797018963968")));
    CHECK(exact(0x1p-1074) * (Rational(pow(Integer(2), 1074U))) == 1);
    CHECK_THROWS_AS(exact(infinity), BrokenInvariant);
    CHECK_THROWS_AS(exact(-infinity), BrokenInvariant);
    CHECK_THROWS_AS(exact(not_a_number), BrokenInvariant);
}

TEST_CASE("The exact ends of a BigInterval are rationals") {
    const PrecisionScope scope(300);
    const BigInterval third = BigInterval(1) / BigInterval(3);
    CHECK(exact_lo(third) < Rational(1, 3));
    CHECK(exact_hi(third) > Rational(1, 3));
    CHECK(exact_hi(third) - exact_lo(third) < Rational(1) / exact(0x1p300));
    CHECK(exact_lo(BigInterval(-0.75, 2)) == Rational(-3, 4));
    CHECK(exact_hi(BigInterval(-0.75, 2)) == 2);
    CHECK_THROWS_AS(exact_hi(BigInterval(1) / BigInterval(0, 1)), BrokenInvariant);
    CHECK_THROWS_AS(exact_lo(BigInterval(not_a_number)), BrokenInvariant);
}

TEST_CASE("A number with a sign, and what is meant by one that is none keeps it") {
    CHECK(parse_signed_rational("-1/2") == Rational(-1, 2));
    CHECK(parse_signed_rational("4.5") == Rational(9, 2));
    const auto meant = [](const char* text) { return refusal(text, parse_signed_rational); };
    for (const auto& [text, likely] : {std::pair{"-.5", "-0.5"},
                                       {"+.5", "0.5"},
                                       {"-5.", "-5"},
                                       {"-4,61", "-4.61"},
                                       {"\u22121/3", "-1/3"},
                                       {"\u2013.5", "-0.5"}}) {
        CHECK_THAT(meant(text), EndsWith(std::string("is not a number: write ") + likely));
    }
    for (const char* text : {"-inf", "-0x1p-1", "--1", "-"}) {
        CHECK(meant(text) == fmt::format("'{}' is not a number: write it like 10, 4.6, 1e6 or 9/2", text));
    }
}
