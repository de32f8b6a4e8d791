#include "pictures/label_places.hpp"

#include <cmath>

#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;

namespace {

const PixelRange page{0, 0, 400, 400};

}  // namespace

TEST_CASE("a number stands above a point that has room") {
    const auto places = label_places({{200, 200}}, {}, 17, page);
    REQUIRE(places.size() == 1);
    REQUIRE(places[0]);
    CHECK(places[0]->x == Approx(200));
    CHECK(places[0]->y < 200);
}

TEST_CASE("numbers stay in the range and off one another, off the points and the path") {
    const std::vector<Pixel> points{{5, 5}, {200, 200}, {204, 203}, {395, 395}};
    const std::vector<Pixel> path{{200, 0}, {200, 400}};
    const auto places = label_places(points, path, 17, page);
    REQUIRE(places.size() == points.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        REQUIRE(places[i]);
        CHECK(places[i]->x > 0);
        CHECK(places[i]->x < 400);
        CHECK(std::abs(places[i]->x - 200) >= 7);
        for (std::size_t j = 0; j < i; ++j) {
            CHECK(
                (std::abs(places[i]->x - places[j]->x) >= 17 || std::abs(places[i]->y - places[j]->y) >= 14));
        }
    }
}

TEST_CASE("where there is no room a number is left out, not printed over another") {
    const std::vector<Pixel> crowd(40, Pixel{200, 200});
    const auto places = label_places(crowd, {}, 17, page);
    CHECK(places.front().has_value());
    CHECK_FALSE(places.back().has_value());
}
