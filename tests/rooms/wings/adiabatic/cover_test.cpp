#include "adiabatic/cover.hpp"

#include <cmath>

#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;

namespace {

Box unit_square() {
    Box box;
    box.hi[0] = box.hi[1] = 1;
    return box;
}

// An upper bound of x + y^2 over a box, outside where x < 1/4.
Judged judge(const Box& box) {
    if (box.hi[0] < 0.25) {
        return {true};
    }
    return {false, box.hi[0] + box.hi[1] * box.hi[1], 3};
}

Limits jobs(int number) {
    Limits limits;
    limits.jobs = number;
    return limits;
}

long leaves(const Tree& tree, bool outside) {
    long n = 0;
    for (const Node& node : tree) {
        n += !node.split && node.outside == outside ? 1 : 0;
    }
    return n;
}

}  // namespace

TEST_CASE("The bound of a cover is within the slack of the greatest value") {
    for (const double slack : {0.5, 0.1, 0.01}) {
        const auto cover = find_cover(unit_square(), judge, {0, slack, false}, jobs(1));
        REQUIRE(cover);
        CHECK(cover->bound >= 2);
        CHECK(cover->bound <= 2 * (1 + slack));
        CHECK(static_cast<long>(cover->leaves) == leaves(cover->tree, true) + leaves(cover->tree, false));
    }
}

TEST_CASE("A goal that is great enough closes the root, and a fixed one that is too small closes nothing") {
    const auto whole = find_cover(unit_square(), judge, {2, 0, true}, jobs(1));
    REQUIRE(whole);
    CHECK(whole->tree.size() == 1);
    CHECK(whole->tree[0].by_class == 3);
    Limits few;
    few.max_leaves = 1000;
    CHECK_FALSE(find_cover(unit_square(), judge, {1.9, 0, true}, few));
}

TEST_CASE("A target that cannot be met is raised to what the halving reaches") {
    Limits few;
    few.max_leaves = 16;
    const auto cover = find_cover(
        unit_square(),
        [](const Box& box) {
            return Judged{false, 1 + 8 * (box.width(Axis::u) + box.width(Axis::sigma)), 0};
        },
        {1, 0.001, false}, few);
    REQUIRE(cover);
    CHECK(cover->bound > 1.1);
    CHECK(cover->leaves <= 16);
}

TEST_CASE("Where the centre of a box has no bound good enough, halving ends at once") {
    for (const bool fixed : {true, false}) {
        long asked = 0;
        const auto stubborn = [&](const Box& box) {
            ++asked;
            // At (3/4, 3/4) and around it too great, or without any bound.
            const bool around =
                box.lo[0] <= 0.75 && 0.75 <= box.hi[0] && box.lo[1] <= 0.75 && 0.75 <= box.hi[1];
            const double bad = fixed ? 1.6 : std::numeric_limits<double>::infinity();
            return Judged{false, around ? bad : box.hi[0] + box.width(Axis::sigma), 0};
        };
        CHECK_FALSE(find_cover(unit_square(), stubborn, {1.5, 0, fixed}, jobs(1)));
        CHECK(asked < 100);
    }
}

TEST_CASE("The tree does not depend on the number of threads") {
    const auto one = find_cover(unit_square(), judge, {0, 0.003, false}, jobs(1));
    const auto four = find_cover(unit_square(), judge, {0, 0.003, false}, jobs(4));
    REQUIRE(one);
    REQUIRE(four);
    CHECK(one->tree == four->tree);
    CHECK(one->bound == four->bound);
}

TEST_CASE("What is interrupted, or has no bound anywhere, gives nothing") {
    Limits stopped;
    stopped.interrupted = [] { return true; };
    CHECK_FALSE(find_cover(unit_square(), judge, {0, 0.1, false}, stopped));
    Limits few;
    few.max_leaves = 100;
    CHECK_FALSE(find_cover(
        unit_square(), [](const Box&) { return Judged{}; }, {0, 0.1, false}, few));
}
