#include "pictures/start_plane.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/sample.hpp"

using namespace dumbbell;
using namespace dumbbell_test;
using namespace dumbbell::pictures;
using namespace dumbbell::starts;

TEST_CASE("the leaves lie in the unit square as the tree says, and tile it") {
    const StartPlane plane = start_plane(sample_initial());
    CHECK(plane.axes == std::array{starts::Axis::phi, starts::Axis::ydot});
    REQUIRE(plane.cells.size() == 4);
    const Rational half(1, 2);
    CHECK(plane.cells[0].box.hi == PlanePoint{half, half});
    CHECK(plane.cells[1].box.lo == PlanePoint{0, half});
    CHECK(plane.cells[2].box.lo == PlanePoint{half, 0});
    CHECK(plane.cells[3].box.lo == PlanePoint{half, half});
    Rational area = 0;
    for (const StartCell& cell : plane.cells) {
        area += cell.area();
    }
    CHECK(area == 1);
}

TEST_CASE("only a leaf with one count is exact: not one with two, nor an open one") {
    CHECK(StartCell{{}, exactly(0).leaf}.is_exact());
    CHECK(StartCell{{}, exactly(3).leaf}.is_exact());
    CHECK_FALSE(StartCell{{}, between(1, 2).leaf}.is_exact());
    CHECK_FALSE(StartCell{{}, open_leaf().leaf}.is_exact());
}

TEST_CASE("a picture needs two intervals: the message says how many there are") {
    starts::Certificate certificate = sample_initial();
    certificate.box.hi[4] = 11;
    CHECK_THROWS_WITH(start_plane(certificate), Contains("3 of phi"));
    CHECK_THROWS_AS(start_plane(certificate), InputError);
    certificate.box.hi = certificate.box.lo;
    CHECK_THROWS_WITH(start_plane(certificate), Contains("0 of phi"));
}

TEST_CASE("what is no interval is named with its number") {
    CHECK(fixed_quantities(sample_initial()) == "phidot = 1, y = 2, q = 10");
    starts::Certificate certificate = sample_initial();
    certificate.box.lo[1] = certificate.box.hi[1] = Rational(-1, 3);
    CHECK_THAT(fixed_quantities(certificate), Contains("1/3") && !Contains("phidot = 1/3"));
}

TEST_CASE("the axes have the ends of the box and the names of the format") {
    const PlotAxis phi = plot_axis(sample_initial(), starts::Axis::phi);
    CHECK(phi.lo == 0);
    CHECK(phi.hi == 4);
    CHECK_THAT(phi.label, Contains("phi") && Contains("radians"));
    CHECK_THAT(plot_axis(sample_initial(), starts::Axis::ydot).label, Contains("ydot"));
}
