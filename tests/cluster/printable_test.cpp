#include "cluster/printable.hpp"

#include <catch2/catch.hpp>

using dumbbell::last_line;
using dumbbell::printable;

TEST_CASE("what is no printable character cannot reach a terminal") {
    CHECK(printable("host-1", 10) == "host-1");
    CHECK(printable("a\x1b[31m\nb\xff", 10) == "a?[31m?b?");
    CHECK(printable("abcdef", 6) == "abcdef");
    CHECK(printable("abcdefg", 6) == "abcdef...");
}

TEST_CASE("the last line that says something is found") {
    CHECK(last_line("").empty());
    CHECK(last_line(" \n\r\n").empty());
    CHECK(last_line("one") == "one");
    CHECK(last_line("one\n  two \n\n \n") == "two");
    CHECK(last_line("over\rwritten\r\n") == "written");
}
