#include "pictures/cover.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using dumbbell::InputError;
using dumbbell::Rational;
using namespace dumbbell::collisions;
using namespace dumbbell::pictures;

namespace {

Node split(Axis axis) { return {axis, {}}; }
Node leaf(Reason reason, long forward = 0, long backward = 0) { return {{}, {reason, forward, backward}}; }

// q in [4, 8]: bridge e halved, its upper half outside, the lower half's ratios halved; light not split.
Piece turning_piece() {
    Piece piece;
    piece.q_lo = 4;
    piece.q_hi = 8;
    piece.upper = 4;
    piece.cover.charts = {{Chart::bridge,
                           {split(Axis::position), split(Axis::ratio), leaf(Reason::count, 1, 1),
                            leaf(Reason::count, 1, 2), leaf(Reason::outside)}},
                          {Chart::light, {leaf(Reason::meets)}}};
    piece.lower = 3;
    piece.witness = Witness{Rational(1, 2), Rational(1, 2), 1, 1};
    return piece;
}

long boxes_in(const std::string& svg) {
    long n = 0;
    for (std::size_t at = svg.find("<path class=\"box"); at != std::string::npos;
         at = svg.find("<path class=\"box", at + 1)) {
        const std::string path = svg.substr(at, svg.find("/>", at) - at);
        n += count_of(path, "z");
    }
    return n;
}

}  // namespace

TEST_CASE("a cover is cut at one mass ratio: boxes of other ratios are not in the picture") {
    const std::string low = cover_svg(turning_piece(), 5);
    CHECK(well_formed(low));
    CHECK(boxes_in(low) == 3);
    CHECK_THAT(low,
               Contains("box n3") && !Contains("box n4") && Contains("box outside") && Contains("box meets"));
    const std::string high = cover_svg(turning_piece(), 7);
    CHECK_THAT(high, Contains("box n4") && !Contains("box n3"));
    CHECK(boxes_in(cover_svg(turning_piece(), 6)) == 3);  // where two boxes meet: one of them
    CHECK(boxes_in(cover_svg(turning_piece(), 8)) == 3);  // the end of the range
    CHECK(boxes_in(cover_svg(turning_piece(), 4)) == 3);
}

TEST_CASE("each chart has its frame, its axes' names and its boxes, and the witness is marked") {
    const std::string svg = cover_svg(turning_piece(), 5);
    CHECK_THAT(svg, Contains("chart bridge") && Contains("chart light") &&
                        Contains(">e: angle from the corner<") &&
                        Contains(">eta: slope above the tangent, in units of 1/q<") &&
                        Contains(">lambda: slope, in units of 1/q<"));
    CHECK(count_of(svg, "class=\"witness\"") == 1);
    CHECK_THAT(svg, Contains("v/(1 + v)") && Contains("3 boxes") && !Contains("nan"));
    Piece piece = turning_piece();
    piece.witness.reset();
    CHECK(count_of(cover_svg(piece, 5), "class=\"witness\"") == 0);
}

TEST_CASE("a count that no box proves is missing in the legend, and the caption says why") {
    Piece piece = turning_piece();
    CHECK_THAT(cover_svg(piece, 5), !Contains("belongs to no box"));
    piece.cover.charts[1].tree = {leaf(Reason::count, 3, 3)};
    CHECK_THAT(cover_svg(piece, 5),
               Contains("box n3") && Contains("box n7") && Contains("belongs to no box"));
}

TEST_CASE("the full section has three charts and counts forward") {
    Piece piece;
    piece.q_lo = piece.q_hi = 10;
    piece.upper = 4;
    piece.cover.charts = {{Chart::contact, {leaf(Reason::count, 3)}},
                          {Chart::departure, {leaf(Reason::count, 2)}},
                          {Chart::again, {leaf(Reason::once)}}};
    const std::string svg = cover_svg(piece, 10);
    CHECK(well_formed(svg));
    CHECK(boxes_in(svg) == 3);
    CHECK_THAT(svg, Contains("chart again") && Contains("box n4") && Contains("box n3") &&
                        Contains("box once") && Contains("counted forward"));
}

TEST_CASE("a cover without boxes, or with too many, is refused") {
    Piece piece;
    piece.q_lo = piece.q_hi = 1;
    piece.upper = 2;
    piece.cover.equal_masses = true;
    CHECK_THROWS_AS(cover_svg(piece, 1), InputError);
    Piece large = turning_piece();
    large.cover.charts[1].tree.assign(2 * most_drawn_boxes, leaf(Reason::meets));
    CHECK_THROWS_WITH(cover_svg(large, 5), Contains("dumbbell report"));
}
