#include "number/rounding.hpp"

#include <bit>
#include <cmath>

#include "catch.hpp"
#include "random.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("next_down steps over every seam of the doubles") {
    CHECK(next_down(1.0) == 0x1.fffffffffffffp-1);
    CHECK(next_down(0x1p-1022) == 0x0.fffffffffffffp-1022);
    CHECK(same_bits(next_down(least), 0.0));
    CHECK(next_down(0.0) == -least);
    CHECK(next_down(-0.0) == -least);
    CHECK(next_down(-least) == -2 * least);
    CHECK(next_down(-0x0.fffffffffffffp-1022) == -0x1p-1022);
    CHECK(next_down(-1.0) == -0x1.0000000000001p0);
    CHECK(next_down(-greatest) == -infinity);
    CHECK(next_down(-infinity) == -infinity);
    CHECK(next_down(infinity) == greatest);
    CHECK(std::isnan(next_down(not_a_number)));
    CHECK(std::isnan(next_down(-not_a_number)));
}

TEST_CASE("next_up steps over every seam of the doubles") {
    CHECK(next_up(0x1.fffffffffffffp-1) == 1.0);
    CHECK(next_up(1.0) == 0x1.0000000000001p0);
    CHECK(next_up(0.0) == least);
    CHECK(next_up(-0.0) == least);
    CHECK(next_up(-least) == 0.0);
    CHECK(next_up(greatest) == infinity);
    CHECK(next_up(infinity) == infinity);
    CHECK(next_up(-infinity) == -greatest);
    CHECK(std::isnan(next_up(not_a_number)));
}

TEST_CASE("next_down and next_up agree with nextafter on any bit pattern") {
    Random random(1);
    for (int i = 0; i < 300'000; ++i) {
        const auto v = i % 2 == 0 ? std::bit_cast<double>(random.bits()) : adversarial(random);
        if (std::isnan(v)) {
            if (!std::isnan(next_down(v)) || !std::isnan(next_up(v))) {
                FAIL(say("a neighbour of NaN is a number:", v));
            }
            continue;
        }
        if (next_down(v) != std::nextafter(v, -infinity) || next_up(v) != std::nextafter(v, infinity)) {
            FAIL(say("v =", v, "down", next_down(v), "up", next_up(v)));
        }
        if (v != infinity && next_down(next_up(v)) != v) {
            FAIL(say("down does not undo up:", v));
        }
    }
}

TEST_CASE("NeighbourRounding knows the square root of 0") {
    CHECK(same_bits(NeighbourRounding::sqrt_down(0.0), 0.0));
    CHECK(NeighbourRounding::sqrt_up(0.0) == 0.0);
}

TEST_CASE("A result beyond the range of double keeps a finite bound on the inner side") {
    CHECK(NeighbourRounding::mul_down(1e200, 1e200) == greatest);
    CHECK(NeighbourRounding::mul_up(1e200, 1e200) == infinity);
    CHECK(NeighbourRounding::mul_up(-1e200, 1e200) == -greatest);
    CHECK(NeighbourRounding::mul_down(-1e200, 1e200) == -infinity);
    CHECK(NeighbourRounding::mul_down(1e-200, 1e-200) == -least);  // 0 < the product < least
    CHECK(NeighbourRounding::mul_up(1e-200, 1e-200) == least);
}
