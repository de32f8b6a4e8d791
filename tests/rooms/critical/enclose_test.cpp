#include "critical/enclose.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/step_guess.hpp"
#include "flight/macro/when.hpp"
#include "number/decimal.hpp"
#include "rooms/collisions/critical_ratio.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::critical;
using namespace dumbbell_test;

namespace {

Ratio enclosed(long n, int digits) {
    auto ratio = enclose_ratio(n, {.digits = digits});
    REQUIRE(ratio);
    return *ratio;
}

std::string digits_of(const Ratio& ratio, int digits) {
    const auto shared = shared_digits(ratio.q_lo, ratio.q_hi, digits);
    REQUIRE(shared);
    return to_text(*shared);
}

// sqrt(1 + x^2), x the first positive root of tan x = x, in 1060 digits.
std::string closed_form(std::size_t characters) {
    using Digits1060 = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<1060>,
                                                     boost::multiprecision::et_off>;
    Digits1060 x = 4.4934;
    for (int i = 0; i < 14; ++i) {
        x -= (sin(x) - x * cos(x)) / (x * sin(x));
    }
    return Digits1060(sqrt(1 + x * x)).str(1050, std::ios::fixed).substr(0, characters);
}

Ratio moved(Ratio ratio, const Rational& below, const Rational& above) {
    ratio.q_lo *= below;
    ratio.q_hi *= above;
    return ratio;
}

}  // namespace

TEST_CASE("q_c(3) is 1, exactly, with any number of digits") {
    for (const int digits : {1, 15, 50, 200, 1000}) {
        const Ratio ratio = enclosed(3, digits);
        CHECK(ratio.q_lo == 1);
        CHECK(ratio.q_hi == 1);
    }
}

TEST_CASE("q_c(4) has the 1000 digits of sqrt(1 + x^2), tan x = x") {
    CHECK(digits_of(enclosed(4, 1000), 1000) == closed_form(1001));
    CHECK(digits_of(enclosed(4, 200), 200) == closed_form(201));
    CHECK(digits_of(enclosed(4, 15), 15) == "4.60333884875170");
}

TEST_CASE("critical ratios are where the count recomputed in 80 digits steps up") {
    for (long n = 4; n <= (scaled(1) < 20 ? 9 : 12); ++n) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 70);
        const Rational reference = critical_ratio(n);  // below q_c(n), by at most 1e-60 q_c(n)
        CHECK(reference <= ratio.q_hi);
        CHECK(ratio.q_lo <= reference * (1 + parse_rational("2e-60")));
        CHECK(ratio.q_hi - ratio.q_lo < ratio.q_lo * parse_rational("1e-70"));
    }
}

TEST_CASE(
    "On both sides of an enclosure the maximum recomputed in 80 digits is N - 1 and N, for longer orbits "
    "too") {
    for (const long n : {13L, 50L, 101L, 202L}) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 30);
        CHECK(reference_maximum(ratio.q_lo * (1 - parse_rational("1e-40"))) == n - 1);
        CHECK(reference_maximum(ratio.q_hi * (1 + parse_rational("1e-40"))) == n);
        CHECK(std::abs(guess_step(n) / ratio.q_lo.convert_to<double>() - 1) < 1e-11);
    }
}

TEST_CASE("More digits refine: each shares the digits asked for, and begins with those of less precision") {
    const std::string all = digits_of(enclosed(5, 110), 110);
    CHECK(all.size() == 111);
    for (const int digits : {3, 10, 25, 39, 40, 60, 109}) {
        CAPTURE(digits);
        const Ratio ratio = enclosed(5, digits);
        CHECK(digits_of(ratio, digits) == all.substr(0, static_cast<std::size_t>(digits) + 1));
        const Rational narrow = ratio.q_hi - ratio.q_lo;
        CHECK(narrow < exact(Decimal{Integer(1), 2 - digits}));
    }
}

TEST_CASE("1000 digits lie within 200") {
    for (const long n : {4, 5, 30, 31}) {
        CAPTURE(n);
        const Ratio coarse = enclosed(n, 200), fine = enclosed(n, most_digits);
        CHECK(coarse.q_lo < fine.q_lo);
        CHECK(fine.q_hi < coarse.q_hi);
        CHECK(fine.q_hi - fine.q_lo < fine.q_lo * parse_rational("1e-998"));
    }
}

TEST_CASE("The least sufficient precision is chosen") {
    CHECK(enclosed(4, 1).bits == 128);
    CHECK(enclosed(4, 15).bits == 128);
    CHECK(enclosed(4, 50).bits == 192);
    CHECK(enclosed(4, 100).bits == 384);
    CHECK(enclosed(4, 200).bits == 704);
}

TEST_CASE("An interrupted enclosure is none, and what has no critical ratio is refused") {
    CHECK_FALSE(enclose_ratio(1'000'000, {.digits = 15, .interrupted = [] { return true; }}));
    int calls = 0;
    CHECK_FALSE(enclose_ratio(100, {.digits = 15, .interrupted = [&] { return ++calls > 100; }}));
    CHECK_THROWS_AS(enclose_ratio(2, {}), BrokenInvariant);
    CHECK_THROWS_AS(enclose_ratio(4, {.digits = most_digits + 1}), BrokenInvariant);
    CHECK_THROWS_AS(enclose_ratio(4, {.digits = 0}), BrokenInvariant);
}

TEST_CASE("a long orbit's critical ratio is where the count recomputed in 80 digits steps up") {
    const long n = dumbbell::flight::macro::first_long;
    const Ratio ratio = enclosed(n, 30);
    CHECK(shared_digits(ratio.q_lo, ratio.q_hi, 30));
    if (scaled(1) < 20) return;  // each count takes a second
    CHECK(reference_maximum(ratio.q_hi * (1 + at("1e-33"))) == n);
    CHECK(reference_maximum(ratio.q_lo * (1 - at("1e-33"))) == n - 1);
}

TEST_CASE("long orbits followed in plain doubles step where their enclosures say") {
    for (const long n : {20'001L, 20'002L, 40'000L, 100'001L}) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 15);
        CHECK(std::abs(guess_step(n) / ratio.q_lo.convert_to<double>() - 1) < 1e-9);
    }
}

TEST_CASE("enclosures of long orbits that miss the critical ratio, however narrowly, are refused") {
    for (const long n : scaled(1) < 20 ? std::vector{20'002L} : std::vector{20'002L, 1'000'001L}) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 20);
        const Rational least = at("1e-19");
        CHECK(certainly_encloses_by_counts(ratio));
        CHECK(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 + least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 - least)));
        Ratio exchanged = moved(ratio, 1 - least, 1 + least);
        std::swap(exchanged.q_lo, exchanged.q_hi);
        CHECK_FALSE(certainly_encloses_by_counts(exchanged));
        for (const long other : {n - 1, n + 1}) {
            Ratio renamed = ratio;
            renamed.n = other;
            CHECK_FALSE(certainly_encloses_by_counts(renamed));
        }
    }
}

TEST_CASE("interval Newton gives the same first long ratio") {
    // `critical 20001 --digits 50` as it was before macro steps.
    const Rational newton = at("509971821.52538596062558050292425816222055680272603");
    const int digits = scaled(1) < 20 ? 20 : 50;
    const Ratio ratio = enclosed(dumbbell::flight::macro::first_long, digits);
    CHECK((ratio.q_lo < newton + at("1e-41") && newton < ratio.q_hi));
    CHECK(ratio.q_hi - ratio.q_lo < exact(Decimal{Integer(1), 9 - digits}));
}

TEST_CASE("more digits of a long orbit's critical ratio begin with the fewer ones") {
    const Ratio few = enclosed(1'000'000, 15);
    const Ratio many = enclosed(1'000'000, 24);
    CHECK(few.q_lo <= many.q_lo);
    CHECK(many.q_hi <= few.q_hi);
    CHECK(to_text(*shared_digits(many.q_lo, many.q_hi, 24)) == "1275051786969.07530004702");
}
