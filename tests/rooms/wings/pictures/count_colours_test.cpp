#include "pictures/count_colours.hpp"

#include <numeric>
#include <set>

#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;

namespace {

std::string fill_of(const std::string& svg, long count) {
    const std::string start = "." + count_kind(count) + "{fill:";
    const std::size_t at = svg.find(start);
    REQUIRE(at != std::string::npos);
    return svg.substr(at + start.size(), 7);
}

// Luminance, about: what is left of a colour in grey print.
double brightness(const std::string& colour) {
    const auto channel = [&](std::size_t at) {
        return static_cast<double>(std::stol(colour.substr(at, 2), nullptr, 16));
    };
    return 0.3 * channel(1) + 0.59 * channel(3) + 0.11 * channel(5);
}

std::string coloured(const std::vector<Count>& counts) {
    Svg svg(1, 1, "colours");
    colour_counts(svg, counts);
    return svg.finished();
}

}  // namespace

TEST_CASE("more collisions are darker: the order of the colours is seen without seeing colours") {
    std::vector<Count> counts(30);
    std::iota(counts.begin(), counts.end(), 1);
    const std::string svg = coloured(counts);
    for (std::size_t i = 1; i < counts.size(); ++i) {
        CHECK(brightness(fill_of(svg, static_cast<long>(i) + 1)) <
              brightness(fill_of(svg, static_cast<long>(i))));
    }
}

TEST_CASE("a count has one colour, whatever else is in a picture") {
    CHECK(fill_of(coloured({0, 1, 2}), 2) == fill_of(coloured({1, 2, 3, 4}), 2));
    CHECK(fill_of(coloured({5}), 5) == fill_of(coloured({2, 5, 600}), 5));
    CHECK(coloured({}).find(".n") == std::string::npos);
}

TEST_CASE("a legend shows all of a few counts, and of many about a dozen from end to end") {
    CHECK(shown_counts({1, 2, 5}) == std::vector<Count>{1, 2, 5});
    std::vector<Count> many(90);
    std::iota(many.begin(), many.end(), 1);
    const auto shown = shown_counts(many);
    CHECK(shown.size() == 13);
    CHECK(shown.front() == 1);
    CHECK(shown.back() == 90);
    CHECK(std::set<Count>(shown.begin(), shown.end()).size() == shown.size());
}
