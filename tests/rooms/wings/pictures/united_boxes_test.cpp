#include "pictures/united_boxes.hpp"

#include <random>

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;

namespace {

PlaneBox box(const Rational& left, const Rational& bottom, const Rational& right, const Rational& top) {
    return {{left, bottom}, {right, top}};
}

// By the even-odd rule: edges crossed by a ray to the right. The point lies on no edge's height.
bool contains(const std::vector<Outline>& outlines, const PlanePoint& p) {
    bool inside = false;
    for (const Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const PlanePoint& a = outline[i];
            const PlanePoint& b = outline[(i + 1) % outline.size()];
            if (a[0] == b[0] && a[0] > p[0] && (a[1] < p[1]) != (b[1] < p[1])) {
                inside = !inside;
            }
        }
    }
    return inside;
}

bool turns_everywhere(const Outline& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint& a = outline[i];
        const PlanePoint& b = outline[(i + 1) % outline.size()];
        const PlanePoint& c = outline[(i + 2) % outline.size()];
        if ((a[0] == b[0]) == (b[0] == c[0])) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("one box is its own outline, and no box has none") {
    CHECK(united({}).empty());
    const auto outlines = united({box(0, 0, 2, 1)});
    REQUIRE(outlines.size() == 1);
    CHECK(outlines[0] == Outline{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
}

TEST_CASE("places that no double tells apart stay apart") {
    const Rational tiny(Integer(1), Integer(1) << 200U);
    const auto outlines =
        united({box(0, 0, tiny, 1), box(tiny, 0, 2 * tiny, 1), box(3 * tiny, 0, 4 * tiny, 1)});
    REQUIRE(outlines.size() == 2);
    CHECK(outlines[0] == Outline{{0, 0}, {2 * tiny, 0}, {2 * tiny, 1}, {0, 1}});
}

TEST_CASE("boxes that overlap have no outlines: their areas do not add up") {
    CHECK_THROWS_AS(united({box(0, 0, 2, 2), box(1, 1, 3, 3)}), BrokenInvariant);
}

TEST_CASE("a union of random cells contains these cells and no others") {
    constexpr int side = 24;
    std::mt19937 random(1);
    for (const unsigned share : {2U, 3U, 5U}) {
        std::vector<PlaneBox> boxes;
        std::vector<bool> taken;
        for (int i = 0; i < side * side; ++i) {
            taken.push_back(random() % share != 0);
            if (taken.back()) {
                boxes.push_back(box(i % side, i / side, i % side + 1, i / side + 1));
            }
        }
        const auto outlines = united(boxes);
        for (int i = 0; i < side * side; ++i) {
            const PlanePoint middle{Rational(2 * (i % side) + 1, 2), Rational(2 * (i / side) + 1, 2)};
            REQUIRE(contains(outlines, middle) == taken[static_cast<std::size_t>(i)]);
        }
        for (const Outline& outline : outlines) {
            REQUIRE(turns_everywhere(outline));
        }
        CHECK(united(boxes) == outlines);
    }
}
