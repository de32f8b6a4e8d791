#include "law/steps.hpp"

#include "catch.hpp"
#include "critical/enclose.hpp"
#include "law/certificate.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::law;

TEST_CASE("the ends of a step enclose its critical ratio and show the law") {
    const PrecisionScope scope(128);
    const Constants constants;
    for (const long n : {3L, 4L, 8L, 9L, 10L, 21L, 22L, 100L, 901L, 902L}) {
        CAPTURE(n);
        const StepEnds ends = step_ends(n, constants);
        CHECK(shows_the_law(n, ends, constants));
        const auto ratio = dumbbell::critical::enclose_ratio(n, {.digits = 30});
        CHECK((ratio && ends.below <= ratio->q_lo && ratio->q_hi <= ends.above));
    }
}

TEST_CASE("ends that lie too far off show nothing") {
    const PrecisionScope scope(128);
    const Constants constants;
    const StepEnds ends = step_ends(21, constants);
    CHECK_FALSE(shows_the_law(21, {ends.below, ends.above * Rational(101, 100)}, constants));
    CHECK_FALSE(shows_the_law(21, {ends.below * Rational(99, 100), ends.above}, constants));
    // delta < 0.02 at the step to 21, as 0.980 demands: 1/9 more of it would be too much.
    CHECK_FALSE(shows_the_law(21, {ends.below, parse_rational("461.3")}, constants));
}
