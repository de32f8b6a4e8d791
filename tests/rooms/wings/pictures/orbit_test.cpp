#include "pictures/orbit.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/witness.hpp"
#include "collisions/witness_orbit.hpp"
#include "pictures/snapshots.hpp"
#include "xml.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;
using namespace dumbbell_test;

namespace {

std::vector<flight::Collision<Interval>> orbit_at(const Rational& q, long collisions) {
    const auto witness = collisions::find_witness<Interval>(q, q, collisions);
    REQUIRE(witness);
    auto orbit = witness_orbit(*witness, q, 53);
    REQUIRE(orbit.size() == static_cast<std::size_t>(collisions));
    return orbit;
}

}  // namespace

TEST_CASE("every collision is drawn in its place, light and heavy apart, and numbered") {
    const std::string svg = orbit_svg(orbit_at(4, 3), 4);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<circle class=\"light\"") ==
          2 + 3 + 1);  // in the plane, in the snapshots, in the legend
    CHECK(count_of(svg, "<rect class=\"heavy\"") == 1 + 1);
    CHECK(count_of(svg, "class=\"number\"") == 3 + 3);
    CHECK_THAT(svg, Contains("q = 4: an orbit with 3 collisions") && Contains("wide") && !Contains("nan"));
}

TEST_CASE("a low bridge has a picture of its own: ten collisions at q = 100") {
    const auto orbit = orbit_at(100, 10);
    const std::string svg = orbit_svg(orbit, 100);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "class=\"bridge\"") == 2);
    CHECK(count_of(svg, "class=\"flight\" d=") == 2);
    CHECK(count_of(svg, "class=\"number\"") == 10 + 10);
    CHECK(orbit_svg(orbit, 100) == svg);
    CHECK(count_of(orbit_svg(orbit_at(4, 3), 4), "class=\"bridge\"") == 1);
}

TEST_CASE("of many collisions the strip shows the first, the turn and the last, and says so") {
    const std::string svg = orbit_svg(orbit_at(1000, 29), 1000);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<line class=\"flight\"") == 3 + 5 + 3 + 1);  // and the legend's
    CHECK(count_of(svg, ">\xe2\x80\xa6<") == 2);
    CHECK_THAT(svg, Contains("The strip shows") && !Contains("Not all flights"));
    CHECK_THAT(orbit_svg(orbit_at(100, 10), 100), !Contains("The strip shows"));
}

TEST_CASE("of very many flights some are drawn, and the caption says which") {
    const auto orbit = orbit_at(1'000'000, 887);
    const std::string svg = orbit_svg(orbit, 1'000'000);
    const std::size_t at = svg.find("<path class=\"flight\"");
    const std::string path = svg.substr(at, svg.find("/>", at) - at);
    CHECK(count_of(path, "L") <= 60);
    CHECK(count_of(path, "L") >= 40);
    CHECK_THAT(svg, Contains("Not all flights are drawn") && Contains("one in 23 between") &&
                        Contains("The strip shows"));
    for (const char* number : {">1<", ">444<", ">887<"}) {  // the first, the turn, the last
        CHECK_THAT(svg, Contains(number));
    }
    CHECK(orbit[turn_of(orbit)].heavy);
}

TEST_CASE("equal masses are drawn equal, and a heavier one larger, up to a limit") {
    const auto radius = [](const std::string& svg, const std::string& kind) {
        const std::size_t at = svg.rfind("<circle class=\"" + kind + "\"");
        return std::stod(svg.substr(svg.find("r=\"", at) + 3));
    };
    const std::string equal = orbit_svg(orbit_at(1, 2), 1);
    CHECK(radius(equal, "heavy") == radius(equal, "light"));
    const std::string four = orbit_svg(orbit_at(4, 3), 4);
    CHECK(radius(four, "heavy") > radius(four, "light"));
    CHECK(radius(orbit_svg(orbit_at(100, 10), 100), "heavy") > radius(four, "heavy"));
}

TEST_CASE("a piece has the orbit of its witness, unless that has more collisions than a picture shows") {
    collisions::Piece piece;
    CHECK_THROWS_WITH(orbit_svg(piece, 4), Contains("no orbit"));
    piece.witness = collisions::find_witness<Interval>(4, 4, 3);
    CHECK(orbit_svg(piece, 4) == orbit_svg(orbit_at(4, 3), 4));
    piece.witness->forward = most_drawn_collisions;
    CHECK_THROWS_WITH(orbit_svg(piece, 4), Contains("20000 collisions at most"));
}

TEST_CASE("what a stretched detail leaves out has no coordinates that programs cannot draw") {
    const std::string svg = orbit_svg(orbit_at(1'000'000, 887), 1'000'000);
    CHECK(well_formed(svg));
    for (std::size_t at = svg.find_first_of("0123456789"); at != std::string::npos;) {
        const std::size_t end = svg.find_first_not_of("0123456789", at);
        REQUIRE(end - at <= 7);  // the greatest: q = 1000000 in the caption
        at = svg.find_first_of("0123456789", end);
    }
}
