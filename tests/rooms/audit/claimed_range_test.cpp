#include "audit/claimed_range.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

std::pair<Rational, Rational> range_in(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", text);
    return audit::claimed_range(folder / "file.dbc");
}

}  // namespace

TEST_CASE("the range of a certificate is that of its line `ratio`") {
    const std::string head = "dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nclaim collisions\n";
    CHECK(range_in(head + "ratio 22/7 355/113\npieces 1\n") ==
          std::pair(Rational(22, 7), Rational(355, 113)));
    for (const char* wrong : {"22 355/113", "22/7 355", "22/7", "22/7/1 355/113", "22/7 355/113/1",
                              "/7 355/113", "22/ 355/113", "02/7 355/113", "22/07 355/113", "22/0 355/113",
                              "2x/7 355/113", "-22/7 355/113", "22/7 355/113 1/1"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(range_in(head + "ratio " + wrong + "\npieces 1\n"), InputError);
    }
    CHECK_THROWS_AS(range_in(head + "ratio 22/7 355/113"), InputError);
    CHECK_THROWS_AS(range_in(head + std::string(8, '\n') + "ratio 22/7 355/113\n"), InputError);
    CHECK_THROWS_AS(audit::claimed_range("no/such/file.dbc"), InputError);
}
