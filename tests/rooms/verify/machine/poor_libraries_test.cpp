// A program of its own, because its std::fma is not exact, as that of a poor library would be, and its zlib
// gets no memory.
#include <cfloat>

#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/core/number.hpp"
#include "verify/input/bytes.hpp"

using namespace dumbbell_verify;

namespace {
bool with_64_bits = false;  // the product; else it is rounded to 53
}

extern "C" double fma(double a, double b, double c) noexcept {
    if (with_64_bits) {
        return static_cast<double>(static_cast<long double>(a) * b + c);
    }
    const volatile double product = a * b;
    return product + c;
}

extern "C" int inflate(z_streamp /*stream*/, int /*flush*/) { return Z_MEM_ERROR; }

TEST_CASE("the arithmetic is refused where std::fma rounds twice") {
    const volatile double a = 1 + 0x1p-52;
    if (std::fma(a, a, -(1 + 0x1p-51)) != 0) {
        WARN("std::fma is an instruction here, and cannot be replaced");
        return;
    }
    CHECK(mul(up, a, a) == 1 + 0x1p-51);  // the square is greater
    CHECK_FALSE(arithmetic_works());
    if (LDBL_MANT_DIG == 64) {
        with_64_bits = true;
        CHECK(std::fma(1 + 0x1p-30, 1 + 0x1p-30, -(1 + 0x1p-29)) == 0x1p-60);
        CHECK_FALSE(arithmetic_works());
    }
}

TEST_CASE("a compressed file is not called damaged where there is no memory to unpack it") {
    const make::File file(make::gzipped("dumbbell-certificate 1\n"));
    Bytes bytes(file.path());
    CHECK_THROWS_AS(bytes.next(1), std::bad_alloc);
}
