#include "words/text_table.hpp"

#include "catch.hpp"

using namespace dumbbell;

TEST_CASE("columns are flush right, but for one") {
    const std::vector<TableLine> lines{{"a", "bb", "c"}, {"10", "b", "1000"}};
    CHECK(aligned(lines, 0) ==
          "a   bb     c\n"
          "10   b  1000\n");
    CHECK(aligned(lines, 1) ==
          " a  bb     c\n"
          "10  b   1000\n");
    CHECK(aligned({}, 0).empty());
}
