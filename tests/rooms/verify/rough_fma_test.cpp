// A program of its own, because its std::fma rounds the product, too, as that of a poor library would.
#include <catch2/catch.hpp>

#include "verify/number/number.hpp"

using namespace dumbbell_verify;

extern "C" double fma(double a, double b, double c) noexcept {
    const volatile double product = a * b;
    return product + c;
}

TEST_CASE("the arithmetic is refused where std::fma rounds twice") {
    const volatile double a = 1 + 0x1p-52;
    if (std::fma(a, a, -(1 + 0x1p-51)) != 0) {
        WARN("std::fma is an instruction here, and cannot be replaced");
        return;
    }
    CHECK(mul(up, a, a) == 1 + 0x1p-51);  // the square is greater
    CHECK_FALSE(arithmetic_works());
}
