#include "pictures/law.hpp"

#include <cmath>
#include <regex>

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/collisions/sample_report.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;
using namespace dumbbell::pictures;

namespace {

// The paths of a kind, in order.
std::vector<std::string> paths(const std::string& svg, const std::string& kind) {
    std::vector<std::string> result;
    const std::string start = "<path class=\"" + kind + "\" d=\"";
    for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
        result.push_back(svg.substr(at + start.size(), svg.find('"', at + start.size()) - at - start.size()));
    }
    return result;
}

struct Point {
    double x, y;
};

std::vector<Point> points(const std::string& path) {
    static const std::regex pattern("[ML]([-0-9.]+) ([-0-9.]+)");
    std::vector<Point> result;
    for (std::sregex_iterator at(path.begin(), path.end(), pattern), end; at != end; ++at) {
        result.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
    }
    return result;
}

// What a height of the upper picture stands for, by the two dashed lines.
class HeightScale {
  public:
    explicit HeightScale(const std::string& svg) {
        const auto lines = points(paths(svg, "bounds").at(0));
        top_ = lines.front().y;
        bottom_ = lines.back().y;
    }
    [[nodiscard]] double value(double y) const {
        return 2.115 + (0.980 - 2.115) * (y - top_) / (bottom_ - top_);
    }

  private:
    double top_, bottom_;
};

constexpr double C = 0.88559512945, c0 = 0.2058115895;
constexpr double a_pixel = 0.00005;  // of two decimals, as a height

// The staircase around its steps to 9 and 10, and a last piece as long as it takes.
std::vector<Piece> near_nine() {
    return {piece(46, Rational(627, 10), 8, 8), piece(Rational(627, 10), Rational(6272, 100), 9, 8),
            piece(Rational(6272, 100), Rational(816, 10), 9, 9),
            piece(Rational(816, 10), Rational(817, 10), 10, 9), piece(Rational(817, 10), 100, 10, 10)};
}

}  // namespace

TEST_CASE("the picture of the law is well-formed, and the same pieces give the same bytes") {
    for (const auto& pieces : {near_nine(), std::vector{piece(1, 1'000'000, 3, 3)},
                               std::vector{piece(70, 80, 9, 9), open_piece(80, 100)}}) {
        const std::string svg = law_svg(pieces, 1e12);
        CHECK(well_formed(svg));
        CHECK_THAT(svg, !Contains("nan") && !Contains("inf") && !Contains("href"));
        CHECK_THAT(svg, Contains("proved by the certificate") && Contains("0.980") && Contains("2.115") &&
                            Contains("10\xc2\xb9\xc2\xb2"));
        CHECK(svg == law_svg(pieces, 1e12));
    }
}

TEST_CASE("a tooth is N - C sqrt q, from the one end of its piece to the other") {
    const std::string svg = law_svg(near_nine(), 1e12);
    const HeightScale heights(svg);
    const auto teeth = points(paths(svg, "proved").at(0));
    CHECK(heights.value(teeth.front().y) == Approx(8 - C * std::sqrt(46.0)).margin(a_pixel));
    CHECK(heights.value(teeth.back().y) == Approx(10 - C * std::sqrt(100.0)).margin(a_pixel));
}

TEST_CASE("beyond the certificate the law's band lies above 1 - c0 q^(-1/4), up to 2, and so do its strips") {
    const std::string svg = law_svg(near_nine(), 1e12);
    const HeightScale heights(svg);
    const auto band = points(paths(svg, "law").at(0));
    CHECK(heights.value(band.front().y) == Approx(1 - c0 / std::pow(100, 0.25)).margin(a_pixel));
    CHECK(heights.value(band.back().y) == Approx(2).margin(a_pixel));
    CHECK(band.front().x == Approx(points(paths(svg, "proved").at(0)).back().x).margin(0.011));
    const auto strips = points(paths(svg, "strip").at(0));
    CHECK(heights.value(strips.front().y) == Approx(1 - c0 / std::pow(law_from, 0.25)).margin(a_pixel));
    CHECK(strips.front().x < band.front().x);
    CHECK(strips.front().x > points(paths(svg, "proved").at(0)).front().x);
}

TEST_CASE("a step stands where the pieces enclose it, q^(1/4) times as high: the strip is even there") {
    const std::string svg = law_svg(near_nine(), 1e12);
    const auto strip = points(paths(svg, "strip").at(1));
    const double zero = strip.front().y, height = zero - strip.back().y;  // 0 and c0
    const auto lateness = [&](double y) { return c0 * (zero - y) / height; };
    const auto steps = points(paths(svg, "step").at(0));
    REQUIRE(steps.size() == 4);  // from the end of one piece to the beginning of the next
    for (const auto& [at, n, q] : {std::tuple{0, 9, 62.7}, {1, 9, 62.72}, {2, 10, 81.6}, {3, 10, 81.7}}) {
        CHECK(lateness(steps.at(static_cast<std::size_t>(at)).y) ==
              Approx((C * std::sqrt(q) - (n - 2)) * std::pow(q, 0.25)).margin(2e-5));
    }
    // Theorem A, at the other end.
    const auto narrow = points(paths(svg, "law").at(1));
    CHECK(narrow.back().x == Approx(points(paths(svg, "law").at(0)).front().x).margin(800));
    for (const Point& point : narrow) {
        CHECK(lateness(point.y) < c0);
        CHECK(lateness(point.y) > 0.15);
    }
}

TEST_CASE("teeth above 2 are marked, and only before the law begins") {
    const std::string svg =
        law_svg({piece(1, 4, 3, 3), piece(5, 11, 4, 4), piece(12, 64, 5, 5), piece(64, 100, 9, 9)}, 1e6);
    REQUIRE(paths(svg, "exception").size() == 2);
    const double from = points(paths(svg, "strip").at(0)).front().x;
    const auto marked = points(paths(svg, "exception").at(0));
    CHECK(count_of(paths(svg, "exception").at(0), "M") == 3);
    CHECK(marked.front().x < from);
    CHECK_THAT(svg, Contains("below q_c(9) only"));
    CHECK_THAT(law_svg({piece(70, 80, 9, 9)}, 1e6),
               !Contains("exception\"") && !Contains("below q_c(9) only"));
}

TEST_CASE("a gap that shows is filled, one too thin to see draws nothing") {
    CHECK(paths(law_svg(near_nine(), 1e12), "gap").size() == 1);
    const Rational end = 80 + Rational(1, 1'000'000'000);
    CHECK(paths(law_svg({piece(70, 80, 9, 9), piece(80, end, 10, 9), piece(end, 90, 10, 10)}, 1e12), "gap")
              .empty());
}

TEST_CASE("an open piece is hatched in both pictures, and the legend says so") {
    const std::string svg = law_svg({piece(70, 80, 9, 9), open_piece(80, 100)}, 1e6);
    CHECK(count_of(svg, "<rect class=\"hatched\"") == 3);  // and in the legend
    CHECK_THAT(svg, Contains("not decided by it"));
}

TEST_CASE("the law continues no range that ends before it begins, or where the picture does") {
    CHECK_THROWS_AS(law_svg({piece(10, 20, 4, 4)}, 1e12), dumbbell::BrokenInvariant);
    CHECK_THROWS_AS(law_svg({piece(10, 100, 4, 4)}, 100), dumbbell::BrokenInvariant);
    CHECK_THROWS_AS(law_svg({}, 1e12), dumbbell::BrokenInvariant);
}
