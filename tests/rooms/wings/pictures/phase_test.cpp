#include "pictures/phase.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/sample.hpp"
#include "xml.hpp"

using namespace dumbbell;
using namespace dumbbell_test;
using namespace dumbbell::pictures;

TEST_CASE("a phase portrait unites the boxes of a count, and hatches what is not decided") {
    const std::string svg = phase_svg(sample_initial());
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<path class=\"region ") == 2);
    CHECK_THAT(svg, Contains("<path class=\"region n2\" d=\"M0 0h1v2h-1z\"/>"));  // in halves of the box
    CHECK_THAT(svg, Contains("<path class=\"region n1\" d=\"M1 0h1v1h-1z\"/>"));
    CHECK(count_of(svg, "class=\"hatched\"") == 2);  // behind the regions, and in the legend
    CHECK_THAT(svg, Contains("2 (50 %)") && Contains("1 (25 %)") && Contains("undecided (25 %)"));
    CHECK_THAT(svg, Contains("phidot = 1, y = 2, q = 10") && !Contains("nan") && !Contains("inf"));
}

TEST_CASE(
    "what is not decided is hatched behind the regions: no region hides it, and an open leaf is not "
    "decided") {
    starts::Certificate certificate = sample_initial();
    certificate.tree = {open_leaf()};
    const std::string svg = phase_svg(certificate);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<path class=\"region ") == 0);
    CHECK_THAT(svg, Contains("undecided (100 %)"));
    const std::string all = phase_svg(sample_initial());
    CHECK(all.rfind("class=\"hatched\"") < all.find("<path class=\"region "));
}

TEST_CASE("boxes beyond a picture's fineness are drawn, rounded") {
    starts::Certificate certificate = sample_initial();
    certificate.tree.clear();
    for (int i = 0; i < 60; ++i) {
        certificate.tree.push_back(initial_split(starts::Axis::phi));
        certificate.tree.push_back(exactly(i % 2));
    }
    certificate.tree.push_back(exactly(3));
    const std::string svg = phase_svg(certificate);
    CHECK(well_formed(svg));
    CHECK_THAT(svg, !Contains("e+") && !Contains("nan"));
}
