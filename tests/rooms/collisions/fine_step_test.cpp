#include "collisions/fine_step.hpp"

#include "catch.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

/// How far the step lies above q_c(n), in distances of the ratios around it.
Rational error_of(const FineStep& step, const Rational& critical) {
    return (step.at - critical) / (step.above - step.at);
}

}  // namespace

TEST_CASE("a step of short orbits is as near to the true one as it was asked for") {
    for (const long n : {4L, 5L, 6L, 33L, 34L, 1000L}) {
        for (const int share_bits : {24, 53, 120, 150}) {
            CAPTURE(n, share_bits);
            const auto step = find_step(n, share_bits);
            REQUIRE(step);
            const Rational error = error_of(*step, critical_ratio(n));
            CHECK((error > -1 && error < 1));
            const Rational width = (step->above - step->below) * (n - 2) * (Integer(1) << (share_bits - 7));
            CHECK((width > step->at / 2 && width < 2 * step->at));
        }
    }
}

TEST_CASE("so is one of orbits that are followed by macro steps") {
    const Rational critical = at("1275051786969.07530004702");  // `critical 1000000 --digits 24`
    for (const int share_bits : {24, 40}) {
        const auto step = find_step(1'000'000, share_bits);
        REQUIRE(step);
        const Rational error = error_of(*step, critical);
        CHECK((error > -1 && error < 1));
    }
    CHECK_FALSE(find_step(1'000'000, 24, [] { return true; }));
}
