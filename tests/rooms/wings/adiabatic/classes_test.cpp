#include "adiabatic/classes.hpp"

#include "catch.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;

namespace {

Hypotheses run_at(const Rational& lo, const Rational& hi) {
    Hypotheses of;
    of.delta = {lo, hi};
    of.heights = {Rational(0), Rational(9, 10)};
    of.margin = Rational(3, 10);
    return of;
}

}  // namespace

TEST_CASE(
    "Classes are what the format allows: J above 2 pi/sqrt(65), cells from 11/7 down, past the margin") {
    std::vector<Hypotheses> all{run_at(Rational(1, 10), Rational(1, 10))};
    if (scaled(1) >= 20) {
        all.push_back(run_at(Rational(1, 100), Rational(1, 100)));
        all.push_back(run_at(Rational(0), Rational(1, 100)));
    }
    for (const auto& of : all) {
        const auto classes = guess_classes(of);
        REQUIRE_FALSE(classes.empty());
        CHECK(classes.size() <= 64);
        Rational before = 0;
        for (const Class& one : classes) {
            CHECK(one.least_share > Rational(78, 100));
            CHECK(one.least_share > before);
            before = one.least_share;
            CHECK(one.cells.size() <= 4096);
            Rational upper(11, 7);
            for (const auto& cell : one.cells) {
                CHECK(cell.u < upper);
                CHECK(cell.v >= 0);
                upper = cell.u;
            }
            CHECK(upper < of.margin);
        }
    }
}

TEST_CASE("However near the vertical a margin is, the cells are as many as can be looked at, and decrease") {
    Hypotheses of = run_at(Rational(1, 100), Rational(1, 100));
    std::vector<const char*> margins{"1e-5"};
    if (scaled(1) >= 20) margins.insert(margins.end(), {"1e-300", "1e-900"});
    for (const char* margin : margins) {
        of.margin = parse_rational(margin);
        for (const Class& one : guess_classes(of)) {
            CHECK(one.cells.size() < 300);
            for (std::size_t i = 1; i < one.cells.size(); ++i) {
                CHECK(one.cells[i].u < one.cells[i - 1].u);
            }
            CHECK(one.cells.back().u > 0);
        }
    }
}

TEST_CASE("No class is guessed once it is interrupted") {
    CHECK(guess_classes(run_at(Rational(1, 100), Rational(1, 100)), 2, [] { return true; }).empty());
}

TEST_CASE("Slack makes every density greater") {
    const Class one = guess_classes(run_at(Rational(1, 100), Rational(1, 100))).front();
    const Class more = with_slack(one, 1.5);
    REQUIRE(more.cells.size() == one.cells.size());
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
        CHECK(more.cells[i].u == one.cells[i].u);
        CHECK(more.cells[i].v >= one.cells[i].v * Rational(3, 2));
    }
}
