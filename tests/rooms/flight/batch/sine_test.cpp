#include "flight/batch/sine.hpp"

#include <cmath>

#include "catch.hpp"
#include "number/elementary.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

TEST_CASE("Sine and cosine of a lane are the bits of guess_sin_cos, which L14 is about") {
    Random random(401);
    const auto check = [](double x) {
        const auto lane = flight::batch::sin_cos(x);
        const auto known = guess_sin_cos(x);
        if (lane.sin != known.sin || lane.cos != known.cos) {
            FAIL(say("x", x, "sin", lane.sin, known.sin, "cos", lane.cos, known.cos));
        }
    };
    for (int i = 0; i < 100'000; ++i) {
        check(random.coin() ? random.uniform(0, half_pi_hi) : random.scaled(0x1p-1070, 1.5));
    }
    for (const double x : {0.0, quarter_pi, neighbour(quarter_pi, 1), half_pi_hi, 0x1p-1074}) {
        check(x);
    }
}
