#include "report/staircase_plot.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "arith/error.hpp"
#include "sample_report.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;

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
    for (const auto& pieces : {three_pieces(), four_pieces(), std::vector{piece(1, 1'000'000, 3, 3)},
                               std::vector{piece(5, Rational(501, 100), 4, 4)}}) {
        const std::string svg = staircase_svg(pieces, Scene::dumbbell);
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

TEST_CASE("the check of well-formedness can fail") {
    CHECK(well_formed("<a b=\"1\"><c/>text</a>\n"));
    CHECK_FALSE(well_formed("<a><c></a></c>"));
    CHECK_FALSE(well_formed("<a>"));
    CHECK_FALSE(well_formed("<a b=1></a>"));
    CHECK_FALSE(well_formed("<a>1 < 2</a>"));
    CHECK_FALSE(well_formed("<a>1 & 2</a>"));
    CHECK(well_formed("<a b=\"&quot;\">1 &lt; 2 &amp; 3 &gt; 2</a>"));
    CHECK_FALSE(well_formed("<a/><a/>"));
    CHECK_FALSE(well_formed("<a/>text"));
    CHECK_FALSE(well_formed(""));
}

TEST_CASE("the proved staircase goes up, never down, and never above the paper's bound") {
    const std::string svg = staircase_svg(
        {piece(2, 4, 3, 3), piece(4, 5, 4, 3), piece(5, 11, 4, 4), piece(11, 12, 5, 4), piece(12, 15, 5, 5)},
        Scene::dumbbell);
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

TEST_CASE("a narrow range has marks too") {
    const std::string svg = staircase_svg({piece(6, 9, 4, 4)}, Scene::dumbbell);
    for (const char* mark : {">6<", ">7<", ">8<", ">9<"}) {
        CHECK_THAT(svg, Contains(mark));
    }
}

TEST_CASE("an open piece is hatched, and the legend says so") {
    CHECK_THAT(staircase_svg(four_pieces(), Scene::dumbbell),
               Contains("class=\"hatched\"") && Contains("not decided"));
    CHECK_THAT(staircase_svg(three_pieces(), Scene::dumbbell),
               !Contains("class=\"hatched\"") && !Contains("not decided"));
}

TEST_CASE("many counts are drawn by their logarithm: twice as many is the same step up everywhere") {
    const auto proved = heights(
        path_of(staircase_svg({piece(100, 200, 10, 10), piece(200, 500, 20, 20), piece(500, 2000, 40, 40)},
                              Scene::dumbbell),
                "proved"));
    REQUIRE(proved.size() == 3);
    CHECK(proved[0] - proved[1] == Approx(proved[1] - proved[2]).margin(0.02));
}

TEST_CASE("the same pieces give the same bytes") {
    CHECK(staircase_svg(four_pieces(), Scene::dumbbell) == staircase_svg(four_pieces(), Scene::dumbbell));
}

TEST_CASE("a wedge's picture names it, has its own scale, and no curve of the dumbbell") {
    for (const auto& [scene, name] :
         {std::pair{Scene::wedge, "scene wedge"}, std::pair{Scene::hybrid, "scene hybrid"}}) {
        CAPTURE(name);
        const std::string svg = staircase_svg({piece(3, 5, 4, 4), open_piece(5, 20)}, scene);
        CHECK(well_formed(svg));
        CHECK_THAT(path_of(svg, "proved"), Contains("H"));
        CHECK_THAT(svg, Contains(name) && !Contains("class=\"paper\"") && !Contains("class=\"growth\"") &&
                            !Contains("dumbbell") && !Contains("nan") && !Contains("inf"));
        CHECK(well_formed(staircase_svg({open_piece(5, 20)}, scene)));
    }
    CHECK_THAT(staircase_svg(three_pieces(), Scene::dumbbell), Contains("bouncing dumbbell"));
}

TEST_CASE("an empty range has no picture") {
    CHECK_THROWS_AS(staircase_svg({}, Scene::dumbbell), BrokenInvariant);
    CHECK_THROWS_AS(staircase_svg({piece(10, 10, 4, 4)}, Scene::dumbbell), BrokenInvariant);
}
