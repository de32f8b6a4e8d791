#include "number/interval.hpp"

#include <cmath>
#include <vector>

#include "catch.hpp"
#include "random.hpp"
#include "show.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

bool is_nan(const Interval& x) { return std::isnan(x.lo()) && std::isnan(x.hi()); }
bool contains_zero(const Interval& x) { return x.lo() <= 0 && x.hi() >= 0; }

}  // namespace

TEST_CASE("A difference of equal intervals contains 0, a square is no product of independent factors") {
    const Interval x(-1, 2);
    CHECK(contains_zero(x - x));
    CHECK(is(sqr(x), 0, next_up(4.0)));
    CHECK(is(x * x, next_down(-2.0), next_up(4.0)));
}

TEST_CASE("Division by an interval that contains 0 is bounded on one side, or not at all") {
    CHECK(is(Interval(1) / Interval(-1, 1), -infinity, infinity));
    CHECK(is(Interval(-3, 5) / Interval(-2, 7), -infinity, infinity));
    CHECK((Interval(1) / Interval(0, 2)).hi() == infinity);
    CHECK((Interval(1) / Interval(-2, -0.0)).lo() == -infinity);
    CHECK_FALSE(says_something(Interval(1) / Interval(0)));
    CHECK_FALSE(says_something(Interval(0) / Interval(0)));
}

TEST_CASE("No square root goes below 0") {
    for (const Interval& x : {Interval(0), Interval(-1, 0), Interval(-2, 3), Interval(least)}) {
        CHECK(sqrt(x).lo() >= 0);
    }
}

TEST_CASE("A product that underflows keeps its sign's side") {
    const Interval tiny(-1e-200, 1e-200);
    CHECK(is(tiny * tiny, -least, least));
    CHECK(is(tiny * Interval(1e-200), -least, least));
    CHECK(is(Interval(1e-200) * Interval(1e-200), 0, least));
    CHECK((Interval(-1e-200) * Interval(1e-200)).lo() == -least);
    CHECK(is(sqr(tiny), 0, least));
    for (const Interval& x : {Interval(3), Interval(-3, 5), tiny}) {  // but 0 is 0
        CHECK(is(Interval(0) * x, 0, 0));
        CHECK(is(x * Interval(0), 0, 0));
    }
    CHECK(is(Interval(1e-200) / Interval(1e200), 0, least));
    CHECK(is(Interval(-1e-200) / Interval(1e200), -least, 0));
    for (const double divisor : {least, 0.5, 1.0, 2.0}) {  // nor does a quotient that is 0 lose it
        CHECK((Interval(0, 1) / Interval(divisor, 4)).lo() == 0);
    }
}

TEST_CASE("Overflow keeps the enclosure") {
    const Interval big(greatest);
    CHECK(is(big + big, greatest, infinity));
    CHECK(is(-big - big, -infinity, -greatest));
    CHECK(is(sqr(big), greatest, infinity));
    CHECK((big * Interval(0)).lo() <= 0);
    CHECK(is(Interval(0) * Interval(-infinity, infinity), 0, 0));
    CHECK(is((big + big) - (big + big), -infinity, infinity));
}

TEST_CASE("Nothing is ever certain about NaN or about an empty interval") {
    const Interval one(1, 2);
    for (const Interval& bad :
         {Interval(not_a_number), Interval(not_a_number, 1), Interval(1, not_a_number), Interval(2, 1)}) {
        CAPTURE(show(bad));
        const std::vector<Interval> results = {
            bad,           bad + one,     one + bad,     bad - one,     one - bad,     bad * one,
            one * bad,     bad / one,     one / bad,     -bad,          sqr(bad),      sqrt(bad),
            abs(bad),      min(bad, one), min(one, bad), max(bad, one), max(one, bad), low_end(bad),
            high_end(bad), midpoint(bad), bad - bad,     bad * bad,     bad / bad,     bad * Interval(0)};
        for (std::size_t i = 0; i < results.size(); ++i) {
            CAPTURE(i, show(results[i]));
            CHECK_FALSE(says_something(results[i]));
        }
        CHECK(std::isnan(approximate(bad)));
        CHECK(std::isnan(width(bad)));
    }
    CHECK(is_nan(sqrt(Interval(-2, -1))));
}

TEST_CASE("A hull, minimum or maximum with NaN is NaN, also where only one end is") {
    const Interval one(1, 2);
    CHECK_FALSE(says_something(hull(Interval(not_a_number), one)));
    CHECK_FALSE(says_something(hull(one, Interval(not_a_number))));
    CHECK_FALSE(says_something(hull(Interval(not_a_number), Interval(not_a_number))));
    const Interval half = Interval(1, infinity) - Interval(infinity);
    REQUIRE((half.lo() == -infinity && std::isnan(half.hi())));
    for (const Interval& bad : {half, -half, Interval(not_a_number)}) {
        for (const Interval& x :
             {hull(bad, one), hull(one, bad), max(bad, one), max(one, bad), min(bad, one), min(one, bad)}) {
            CHECK(is_nan(x));
        }
    }
}

TEST_CASE("Comparisons are certain only where every pair of points agrees") {
    CHECK(certainly_less(Interval(1, 2), Interval(3, 4)));
    CHECK_FALSE(certainly_less(Interval(1, 2), Interval(2, 3)));
    CHECK(certainly_at_most(Interval(1, 2), Interval(2, 3)));
    CHECK_FALSE(certainly_at_most(Interval(1, next_up(2.0)), Interval(2, 3)));
    CHECK_FALSE(certainly_less(Interval(3, 4), Interval(1, 2)));
    CHECK(certainly_positive(Interval(0x1p-1074, 1)));
    CHECK_FALSE(certainly_positive(Interval(0, 1)));
    CHECK_FALSE(certainly_positive(Interval(-0.0, 1)));
    CHECK_FALSE(certainly_positive(Interval(-1, 1)));
}

TEST_CASE("Ends, middle and width") {
    const Interval x(1, 2);
    CHECK(is(low_end(x), 1, 1));
    CHECK(is(high_end(x), 2, 2));
    CHECK(approximate(x) == 1.5);
    CHECK(is(midpoint(x), 1.5, 1.5));
    CHECK(width(x) >= 1);
    CHECK(width(Interval(0x1p-1074, 1)) >= 1);
    CHECK(is(Interval(), 0, 0));
    CHECK(is(Interval(3), 3, 3));
}
