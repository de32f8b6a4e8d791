#include "collisions/plan.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

std::vector<PlannedPiece> whole_plan(const Rational& lo, const Rational& hi, const Rational& gap) {
    std::vector<PlannedPiece> whole;
    for (Rational from = lo; from < hi; from = whole.back().q_hi) {
        const auto part = plan_staircase({.range = {lo, hi}, .gap = gap}, from).pieces;
        REQUIRE_FALSE(part.empty());
        whole.insert(whole.end(), part.begin(), part.end());
    }
    return whole;
}

// The least N whose step lies above q.
Rational next_step_above(const Rational& q) { return critical_ratio(reference_maximum(q) + 1); }

void check_tiles(const std::vector<PlannedPiece>& plan, const Rational& lo, const Rational& hi) {
    REQUIRE_FALSE(plan.empty());
    CHECK(plan.front().q_lo == lo);
    CHECK(plan.back().q_hi == hi);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        CHECK(plan[i].q_lo <= plan[i].q_hi);
        CHECK((i == 0 || plan[i].q_lo == plan[i - 1].q_hi));
        CHECK((plan[i].q_lo < plan[i].q_hi || plan[i].q_lo == 1));
        CHECK((plan[i].upper == plan[i].lower || plan[i].upper == plan[i].lower + 1));
    }
}

// Pieces say what the recomputation in 80 digits says at both ends (N* does not decrease in between).
void check_values(const std::vector<PlannedPiece>& plan) {
    for (const PlannedPiece& p : plan) {
        CAPTURE(p.q_lo, p.q_hi);
        CHECK(reference_maximum(p.q_hi) == p.upper);
        CHECK((p.q_lo == 1 ? 2 : reference_maximum(p.q_lo)) == p.lower);
    }
}

void check_gaps(const std::vector<PlannedPiece>& plan, const Rational& gap) {
    for (const PlannedPiece& p : plan) {
        if (p.upper == p.lower) {
            continue;
        }
        CAPTURE(p.q_lo, p.q_hi);
        const Rational width = p.q_hi - p.q_lo;
        CHECK(width <= gap * p.q_lo);
        CHECK(width * 1000 <= next_step_above(p.q_hi) - p.q_hi);
        const Rational before = p.lower >= 4 ? critical_ratio(p.lower) : Rational(1);
        CHECK((p.q_lo == 1 || width * 1000 <= p.q_lo - before));
    }
}

void check_plan(const Rational& lo, const Rational& hi, const Rational& gap) {
    CAPTURE(lo, hi, gap);
    const auto plan = whole_plan(lo, hi, gap);
    check_tiles(plan, lo, hi);
    check_values(plan);
    check_gaps(plan, gap);
}

}  // namespace

TEST_CASE("pieces tile the range exactly, are true, and gaps keep the contract's width") {
    for (const char* gap : steps<const char*>({"0.01", "1e-20"}, {"1e-4", "1e-6", "1e-9", "1e-12"})) {
        check_plan(1, 100, at(gap));
        check_plan(at("4.6"), at("4.61"), at(gap));
        check_plan(at("10/3"), at("1000/7"), at(gap));
    }
    if (scaled(1) >= 20) {
        check_plan(1000, 1200, at("1e-6"));
        check_plan(9900, 10000, at("1e-6"));
    }
}

TEST_CASE("between two steps there is one piece, across one step three") {
    CHECK(plan_staircase({.range = {5, 11}}, 5).pieces.size() == 1);
    const auto plan = plan_staircase({.range = {11, 12}}, 11).pieces;
    REQUIRE(plan.size() == 3);
    CHECK(plan[1].q_lo < critical_ratio(5));
    CHECK(plan[1].q_hi > critical_ratio(5));
    CHECK(plan[0].upper == 4);
    CHECK(plan[1].upper == 5);
    CHECK(plan[1].lower == 4);
    CHECK(plan[2].lower == 5);
}

TEST_CASE("a range from 1 begins with the single ratio 1 and a gap to its right") {
    const auto plan = plan_staircase({.range = {1, 2}}, 1).pieces;
    REQUIRE(plan.size() == 3);
    CHECK(plan[0].q_lo == 1);
    CHECK(plan[0].q_hi == 1);
    CHECK(plan[0].upper == 2);
    CHECK(plan[1].upper == 3);
    CHECK(plan[1].lower == 2);
    CHECK(plan[1].q_hi <= at("1.000001"));
    CHECK(plan[2].lower == 3);
    check_plan(1, at("1.0000000001"), at("1e-6"));  // ends inside the gap
    check_plan(at("1.0000000001"), 2, at("1e-6"));  // begins there: no gap, 1 is not in it
}

TEST_CASE("ranges that begin, end or lie entirely inside a neighbourhood of a critical ratio") {
    for (const long n : {4L, 5L, 6L, 11L}) {
        const Rational c = critical_ratio(n);
        for (const char* text : {"1e-5", "1e-7", "1e-9", "1e-12"}) {
            const Rational d = at(text);
            check_plan(c * (1 - d), c * at("1.01"), at("1e-6"));
            check_plan(c * (1 + d), c * at("1.01"), at("1e-6"));
            check_plan(c * at("0.99"), c * (1 + d), at("1e-6"));
            check_plan(c * at("0.99"), c * (1 - d), at("1e-6"));
            check_plan(c * (1 - d), c * (1 + d), at("1e-6"));
            check_plan(c * (1 - 2 * d), c * (1 - d), at("1e-6"));
            check_plan(c * (1 + d), c * (1 + 2 * d), at("1e-6"));
        }
    }
}

TEST_CASE("inside a gap of its own the whole range is the gap") {
    const Rational c = critical_ratio(4);
    const auto plan =
        plan_staircase({.range = {c * (1 - at("1e-9")), c * (1 + at("1e-9"))}}, c * (1 - at("1e-9"))).pieces;
    REQUIRE(plan.size() == 1);
    CHECK(plan[0].upper == 4);
    CHECK(plan[0].lower == 3);
}

TEST_CASE("the ends of gaps are short decimals") {
    for (const PlannedPiece& p : plan_staircase({.range = {2, 100}}, 2).pieces) {
        if (p.upper != p.lower) {
            CHECK(to_fraction(p.q_lo).size() < 30);
            CHECK(to_fraction(p.q_hi).size() < 30);
        }
    }
}

TEST_CASE("a range with more than a million steps is refused with advice") {
    CHECK_THROWS_AS(plan_staircase({.range = {2, at("1.5e12")}}, 2), InputError);
    CHECK_THROWS_WITH(plan_staircase({.range = {2, at("1.5e12")}}, 2), Contains("in parts"));
}

TEST_CASE("a step that is known exactly, at the left end of the range, is taken there") {
    const auto plan = plan_staircase({.range = {3, 10}, .system = {Section::body, 1}, .gap = {1, 1000}}, 3)
                          .pieces;  // ceil(pi/corner) is 3 at Q = 3
    REQUIRE(plan.size() > 2);
    CHECK((plan[0].q_lo == 3 && plan[0].q_hi == 3 && plan[0].lower == 3 && plan[0].upper == 3));
    CHECK((plan[1].q_lo == 3 && plan[1].q_hi > 3 && plan[1].lower == 3 && plan[1].upper == 4));
    CHECK(plan_staircase({.range = {2, 3}, .system = {Section::body, 1}, .gap = {1, 1000}}, 2)
              .pieces.back()
              .upper == 3);
}

TEST_CASE("a long range is planned part by part, and from behind any gap as in one go") {
    const Rational hi = at("1e5"), gap = at("1e-6");
    const Plan first = plan_staircase({.range = {1, hi}, .gap = gap}, 1);
    CHECK(first.pieces.back().upper == first.pieces.back().lower + 1);
    CHECK(first.pieces.back().q_hi < hi);
    CHECK(first.steps_beyond > 0);
    const auto whole = whole_plan(1, hi, gap);
    check_tiles(whole, 1, hi);
    const std::size_t stride = scaled(1) >= 20 ? 2 : 26;
    for (std::size_t i = 1; i < whole.size(); i += stride) {  // the pieces with odd numbers are gaps
        CAPTURE(i);
        REQUIRE(whole[i].upper == whole[i].lower + 1);
        const auto rest = plan_staircase({.range = {1, hi}, .gap = gap}, whole[i].q_hi).pieces;
        REQUIRE(rest.size() <= whole.size() - i - 1);
        CHECK(std::equal(rest.begin(), rest.end(), whole.begin() + static_cast<std::ptrdiff_t>(i) + 1));
    }
}
