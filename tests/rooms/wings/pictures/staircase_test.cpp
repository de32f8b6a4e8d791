#include "pictures/staircase.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "catch.hpp"
#include "flight/paper_bound.hpp"
#include "rooms/collisions/sample_report.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;
using namespace dumbbell::pictures;

namespace {

std::string path_of(const std::string& svg, const std::string& kind) {
    const std::string start = "<path class=\"" + kind + "\" d=\"";
    const std::size_t at = svg.find(start);
    REQUIRE(at != std::string::npos);
    return svg.substr(at + start.size(), svg.find('"', at + start.size()) - at - start.size());
}

// The heights (SVG: smaller is higher) a path passes, in order.
std::vector<double> heights(const std::string& path) {
    std::vector<double> result;
    for (std::size_t at = path.find_first_of("MV"); at != std::string::npos;
         at = path.find_first_of("MV", at + 1)) {
        const std::size_t number = path[at] == 'V' ? at + 1 : path.find(' ', at) + 1;
        result.push_back(std::stod(path.substr(number)));
    }
    return result;
}

}  // namespace

TEST_CASE("the picture is well-formed XML with its curves and a legend for each") {
    for (const auto& pieces : {three_pieces(), four_pieces(),
                               std::vector{piece(1, 500'000, 3, 3), piece(500'000, 1'000'000, 887, 887)},
                               std::vector{piece(5, Rational(501, 100), 4, 4)}}) {
        const std::string svg = staircase_svg({.pieces = pieces});
        CAPTURE(pieces.size());
        CHECK(well_formed(svg));
        CHECK_THAT(path_of(svg, "proved"), Contains("H"));
        CHECK_THAT(path_of(svg, "paper"), Contains("H"));
        CHECK_THAT(path_of(svg, "growth"), Contains("L"));
        CHECK_THAT(svg, Contains("proved maximum") && Contains("paper's bound"));
        CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
        CHECK_THAT(svg, Contains("xmlns=\"http://www.w3.org/2000/svg\"") && !Contains("href"));
    }
}

TEST_CASE("the proved staircase goes up, never down, and never above the paper's bound") {
    const std::string svg =
        staircase_svg({.pieces = {piece(2, 4, 3, 3), piece(4, 5, 4, 3), piece(5, 11, 4, 4),
                                  piece(11, 12, 5, 4), piece(12, 15, 5, 5)}});
    const auto proved = heights(path_of(svg, "proved"));
    const auto paper = heights(path_of(svg, "paper"));
    REQUIRE(proved.size() >= 3);
    REQUIRE(paper.size() >= 2);
    CHECK(std::is_sorted(proved.rbegin(), proved.rend()));
    CHECK(std::is_sorted(paper.rbegin(), paper.rend()));
    CHECK(paper.front() < proved.front());
    CHECK(paper.back() < proved.back());
    CHECK(proved.back() > 0);
}

TEST_CASE("a line is drawn only where one value is proved, and a gap is filled between its two values") {
    const std::string svg =
        staircase_svg({.pieces = {piece(2, 4, 3, 3), piece(4, 5, 4, 3), piece(5, 8, 4, 4)}});
    const auto numbers = [](const std::string& path) {
        std::vector<double> result;
        for (std::size_t at = path.find_first_of("0123456789"); at != std::string::npos;) {
            std::size_t length = 0;
            result.push_back(std::stod(path.substr(at), &length));
            at = path.find_first_of("0123456789", at + length);
        }
        return result;
    };
    const auto proved = numbers(path_of(svg, "proved"));  // x, y, x of each piece
    const auto gap = numbers(path_of(svg, "gap"));        // x, y, x, y, x
    REQUIRE(proved.size() == 6);
    REQUIRE(gap.size() == 5);
    CHECK(gap[0] == proved[2]);  // the gap goes from the end of one line to the beginning of the next ...
    CHECK(gap[2] == proved[3]);
    CHECK(gap[2] > gap[0] + 50);
    CHECK(gap[1] == proved[1]);  // ... and from the lower value to the upper one
    CHECK(gap[3] == proved[4]);
    CHECK_THAT(path_of(svg, "proved"), !Contains("V"));
    CHECK_THAT(svg, Contains("gap: one of two values"));
    CHECK_THAT(staircase_svg({.pieces = {piece(2, 4, 3, 3)}}), !Contains("gap: one"));
}

TEST_CASE("a range that begins high has the counts that it shows on its axis, and the far bound in words") {
    const std::string high = staircase_svg(
        {.pieces = {piece(1'000'000, 1'005'000, 888, 888), piece(1'005'000, 1'010'000, 890, 890)}});
    const auto proved = heights(path_of(high, "proved"));
    REQUIRE(proved.size() == 2);
    CHECK(proved[0] - proved[1] > 50);
    CHECK_THAT(high, Contains(">889<") && Contains("the paper's bound: 1572 to 1580") &&
                         !Contains("class=\"paper\"") && Contains("1002000"));
    CHECK_THAT(staircase_svg({.pieces = {piece(6, 9, 4, 4)}}), Contains("<path class=\"paper\""));
}

TEST_CASE("a logarithmic axis says so") {
    const std::string svg = staircase_svg({.pieces = {piece(1, 5000, 3, 3), piece(5000, 10000, 60, 60)}});
    CHECK_THAT(svg, Contains("heavy over light, logarithmic") && Contains("collisions (logarithmic)"));
    CHECK_THAT(staircase_svg({.pieces = {piece(6, 9, 4, 4)}}), !Contains("collisions (logarithmic)"));
}

TEST_CASE("a range that doubles can hardly tell from a point is refused") {
    const Rational end = 5 + Rational(1, Integer(1) << 50U);
    CHECK_THROWS_WITH(staircase_svg({.pieces = {piece(5, end, 4, 4)}}), Contains("dumbbell report"));
}

TEST_CASE("an open piece is hatched, and the legend says so") {
    CHECK_THAT(staircase_svg({.pieces = four_pieces()}),
               Contains("class=\"hatched\"") && Contains("not decided"));
    CHECK_THAT(staircase_svg({.pieces = three_pieces()}),
               !Contains("class=\"hatched\"") && !Contains("not decided"));
}

TEST_CASE("many counts are drawn by their logarithm: twice as many is the same step up everywhere") {
    const auto proved =
        heights(path_of(staircase_svg({.pieces = {piece(100, 200, 10, 10), piece(200, 500, 20, 20),
                                                  piece(500, 2000, 40, 40)}}),
                        "proved"));
    REQUIRE(proved.size() == 3);
    CHECK(proved[0] - proved[1] == Approx(proved[1] - proved[2]).margin(0.02));
}

TEST_CASE("an empty range has no picture, nor one that goes too far") {
    CHECK_THROWS_AS(staircase_svg({.pieces = {open_piece(5, 4 * flight::paper_bound_limit())}}), InputError);
    CHECK_THROWS_AS(staircase_svg({.pieces = {}}), BrokenInvariant);
    CHECK_THROWS_AS(staircase_svg({.pieces = {piece(10, 10, 4, 4)}}), BrokenInvariant);
}
