#include "collisions/part.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/plan.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

namespace {

const System dumbbell_turning(Section::turning), ring(Section::body, 1);

RatioPart part_of(const Part& part, const System& system, const Rational& lo, const Rational& hi) {
    return part_of(part, Claim{.range = {lo, hi}, .system = system});
}

std::vector<RatioPart> parts_of(long of, const System& system, const Rational& lo, const Rational& hi) {
    std::vector<RatioPart> parts;
    for (long number = 1; number <= of; ++number) {
        parts.push_back(part_of({number, of}, system, lo, hi));
    }
    return parts;
}

}  // namespace

TEST_CASE("the parts of a range of mass ratios follow one another, from its beginning to its end") {
    for (const System& system : {dumbbell_turning, ring}) {
        const Rational lo = parse_rational("1.5"), hi = parse_rational("1e8");
        const auto parts = parts_of(64, system, lo, hi);
        CHECK(parts.front().range.lo == lo);
        CHECK(parts.back().range.hi == hi);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            CHECK(parts[i].range.lo < parts[i].range.hi);
            CHECK((i == 0 || parts[i].range.lo == parts[i - 1].range.hi));
            CHECK(parts[i].whole.hi == hi);
        }
    }
}

TEST_CASE("a cut is always the same number") {
    CHECK(part_of({2, 4}, Section::turning, 1, 10'000).range.lo == parse_rational("1186.12"));
    CHECK(part_of({7, 64}, Section::turning, 1, 100'000'000).range.hi == parse_rational("10594200.62"));
    CHECK(part_of({3, 4}, ring, 1, 10'000).range.lo == parse_rational("3932.17"));
}

TEST_CASE("a cut is well inside a piece with one value") {
    for (const System& system : {dumbbell_turning, ring}) {
        for (const long of : {2L, 9L, 40L}) {
            const auto plan = plan_staircase({.range = {1, 10'000}, .system = system}, 1).pieces;
            for (const RatioPart& part : parts_of(of, system, 1, 10'000)) {
                const Rational& cut = part.range.hi;
                CAPTURE(of, cut);
                const auto piece = std::ranges::find_if(
                    plan, [&](const PlannedPiece& p) { return p.q_lo < cut && cut <= p.q_hi; });
                REQUIRE(piece != plan.end());
                CHECK(piece->upper == piece->lower);
                if (cut < 10'000) {
                    const Rational quarter = (piece->q_hi - piece->q_lo) / 4;
                    CHECK(cut > piece->q_lo + quarter);
                    CHECK(cut < piece->q_hi - quarter);
                }
            }
        }
    }
}

TEST_CASE("more parts than there are steps are refused, and how many there can be is said") {
    CHECK_THROWS_WITH(part_of({1, 64}, Section::turning, 1, 100),
                      Contains("too few steps for 64 parts: cut it into at most 7"));
    CHECK(parts_of(7, Section::turning, 1, 100).size() == 7);
    CHECK_THROWS_AS(part_of({1, 2}, Section::turning, parse_rational("4.7"), parse_rational("4.8")),
                    InputError);
    CHECK(part_of({1, 1}, Section::turning, parse_rational("4.7"), parse_rational("4.8")).range.hi ==
          parse_rational("4.8"));
}
