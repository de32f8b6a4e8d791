#include "collisions/part.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/plan.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

namespace {

const std::vector<Scene> scenes{Scene::dumbbell, Scene::hybrid, Scene::wedge};

std::vector<RatioPart> parts_of(long of, Scene scene, const Rational& lo, const Rational& hi) {
    std::vector<RatioPart> parts;
    for (long number = 1; number <= of; ++number) {
        parts.push_back(part_of({number, of}, scene, lo, hi));
    }
    return parts;
}

}  // namespace

TEST_CASE("the parts of a range of mass ratios follow one another, from its beginning to its end") {
    for (const Scene scene : scenes) {
        const Rational lo = parse_rational("1.5"), hi = parse_rational("1e8");
        const auto parts = parts_of(64, scene, lo, hi);
        CHECK(parts.front().q_lo == lo);
        CHECK(parts.back().q_hi == hi);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            CHECK(parts[i].q_lo < parts[i].q_hi);
            CHECK((i == 0 || parts[i].q_lo == parts[i - 1].q_hi));
            CHECK(parts[i].whole_hi == hi);
        }
    }
}

TEST_CASE("a cut is always the same number") {
    CHECK(part_of({2, 4}, Scene::dumbbell, 1, 10'000).q_lo == parse_rational("1186.12"));
    CHECK(part_of({7, 64}, Scene::dumbbell, 1, 100'000'000).q_hi == parse_rational("10594200.62"));
    CHECK(part_of({3, 4}, Scene::wedge, 1, 10'000).q_lo == parse_rational("3932.17"));
}

TEST_CASE("a cut is well inside a piece with one value") {
    for (const Scene scene : scenes) {
        for (const long of : {2L, 9L, 40L}) {
            const auto plan = plan_staircase(scene, 1, 10'000, Rational(1, 1'000'000)).pieces;
            for (const RatioPart& part : parts_of(of, scene, 1, 10'000)) {
                const Rational& cut = part.q_hi;
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
    CHECK_THROWS_WITH(part_of({1, 64}, Scene::dumbbell, 1, 100),
                      Contains("too few steps for 64 parts: cut it into at most 7"));
    CHECK(parts_of(7, Scene::dumbbell, 1, 100).size() == 7);
    CHECK_THROWS_AS(part_of({1, 2}, Scene::dumbbell, parse_rational("4.7"), parse_rational("4.8")),
                    InputError);
    CHECK(part_of({1, 1}, Scene::dumbbell, parse_rational("4.7"), parse_rational("4.8")).q_hi ==
          parse_rational("4.8"));
}
