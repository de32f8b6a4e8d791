#include "pictures/shares.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/starts/sample.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using namespace dumbbell::pictures;
using namespace dumbbell::starts;

TEST_CASE("bars of the shares: at least, hatched up to at most, with words that are true") {
    const std::string svg = shares_svg(sample_initial());  // 1: 1/4 to 1/2, 2: 1/2 to 3/4
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<rect class=\"at-least\"") == 3);  // one of them in the legend
    CHECK(count_of(svg, "<rect class=\"hatched\"") == 3);
    CHECK_THAT(svg, Contains("\xe2\x89\xa5 25 %") && Contains("\xe2\x89\xa5 50 %"));
    CHECK_THAT(svg, Contains("phidot = 1, y = 2, q = 10") && !Contains("nan") && !Contains("inf"));
    CHECK(svg == shares_svg(sample_initial()));
}

TEST_CASE("small shares have room below the great ones, many numbers no words") {
    InitialCertificate certificate = sample_initial();
    certificate.box.lo[4] = certificate.box.hi[4] = 10000;
    certificate.tree.clear();
    for (int i = 0; i < 30; ++i) {
        certificate.tree.push_back(initial_split(InitialAxis::phi));
        certificate.tree.push_back(exactly(i));
    }
    certificate.tree.push_back(exactly(30));
    const std::string svg = shares_svg(certificate);
    CHECK(well_formed(svg));
    CHECK(count_of(svg, "<rect class=\"at-least\"") == 32);
    CHECK_THAT(svg, !Contains("\xe2\x89\xa5") && Contains("1e\xe2\x88\x92") && !Contains("nan"));
}

TEST_CASE("a box of which nothing is decided has no bars") {
    InitialCertificate certificate = sample_initial();
    certificate.tree = {open_leaf()};
    CHECK_THROWS_AS(shares_svg(certificate), dumbbell::InputError);
}
