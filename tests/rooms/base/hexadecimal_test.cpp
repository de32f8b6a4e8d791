#include "base/hexadecimal.hpp"

#include <array>
#include <catch2/catch.hpp>

using dumbbell::hexadecimal;

TEST_CASE("bytes are written as two lower-case digits each") {
    constexpr std::array<unsigned char, 5> bytes{0, 9, 16, 171, 255};
    CHECK(hexadecimal(bytes.data(), bytes.size()) == "000910abff");
    CHECK(hexadecimal(bytes.data(), 0).empty());
}
