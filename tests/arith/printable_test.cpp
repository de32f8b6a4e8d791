#include "arith/printable.hpp"

#include <catch2/catch.hpp>

using dumbbell::printable;

TEST_CASE("what is no printable character cannot reach a terminal") {
    CHECK(printable("host-1", 10) == "host-1");
    CHECK(printable("a\x1b[31m\nb\xff", 10) == "a?[31m?b?");
    CHECK(printable("abcdef", 6) == "abcdef");
    CHECK(printable("abcdefg", 6) == "abcdef...");
}
