#include "collisions/cell_reader.hpp"

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

TEST_CASE("the cells of a rectangle are read where its tree has them, but for those beyond the edge") {
    const std::string head =
        "dumbbell-certificate 1\ngenerator dumbbell 0\nlemmas body\nscene body\nsection cells\nclaim "
        "collisions\nratio 1/1 3/1\nrho 1/2 1/1\nbits 96\n";
    const CellFile file = read_cells(
        {"plane", head + "split q\nbeyond\nsplit rho\ncell 5 4 1 1b-1 2\nopen\ntotal split 2\nsha256 0\n"});
    REQUIRE(file.cells.size() == 2);
    const auto& [bodies, lower, upper] = file.cells[0];
    CHECK((bodies.q == Range{2, 3} && bodies.rho == Range{Rational(1, 2), Rational(3, 4)}));
    CHECK((lower == 4 && upper == Count(5) && file.sha256.empty()));
    CHECK((file.cells[1].bodies.rho == Range{Rational(3, 4), 1} && !file.cells[1].upper));
    for (const char* tree : {"", "split e\nopen\nopen\n", "cell 5\n", "count 1\n"}) {
        CHECK_THROWS_AS(read_cells({"plane", head + tree}), InputError);
    }
    const Cells proved = prove_cells({{Rational(1, 2), Rational(3, 5)}, {9, 10}});
    CHECK(read_cells({"own", proved.certificate.text}).sha256 == proved.certificate.sha256);
}
