#include "file/last_line.hpp"

#include "catch.hpp"

using dumbbell::last_line;

TEST_CASE("the last line that says something is found") {
    CHECK(last_line("").empty());
    CHECK(last_line(" \n\r\n").empty());
    CHECK(last_line("one") == "one");
    CHECK(last_line("one\n  two \n\n \n") == "two");
    CHECK(last_line("over\rwritten\r\n") == "written");
}
