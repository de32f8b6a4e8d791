// Lemma L62 (a): both ends of an interval moved outward at once.
#include "number/ends.hpp"

#include <bit>
#include <cmath>

#include "catch.hpp"
#include "number/rounding.hpp"
#include "random.hpp"
#include "show.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

TEST_CASE("above is next_up on any bit pattern, in both places, but -0 stays") {
    Random random(11);
    for (int i = 0; i < 300'000; ++i) {
        const double v = i % 2 == 0 ? std::bit_cast<double>(random.bits()) : adversarial(random);
        const ends::Pair moved = ends::above(ends::Pair{v, -v});
        for (const int place : {0, 1}) {
            const double from = place == 0 ? v : -v;
            const double to = moved[place];
            const bool minus_zero = from == 0 && std::signbit(from);
            if (std::isnan(from) ? !std::isnan(to) : to != (minus_zero ? 0.0 : next_up(from))) {
                FAIL(say("above", from, "is", to));
            }
        }
    }
}

TEST_CASE("above keeps infinity, and every NaN") {
    for (const double v :
         {infinity, not_a_number, -not_a_number, std::bit_cast<double>(0x7fffffffffffffffULL),
          std::bit_cast<double>(0xffffffffffffffffULL)}) {
        const ends::Pair moved = ends::above(ends::Pair{v, 1});
        CHECK((std::isnan(v) ? std::isnan(moved[0]) : moved[0] == v));
        CHECK(moved[1] == next_up(1.0));
    }
    CHECK(ends::above(ends::twice(-infinity))[0] == -greatest);
    CHECK(ends::above(ends::twice(greatest))[0] == infinity);
}
