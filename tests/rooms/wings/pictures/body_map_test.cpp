#include "pictures/body_map.hpp"

#include "catch.hpp"
#include "xml.hpp"

using namespace dumbbell_test;
using namespace dumbbell;
using namespace dumbbell::pictures;

TEST_CASE("a map of bodies unites the cells of one N, and colours steps by kind") {
    const auto cell = [](double rho_lo, double rho_hi, double q_lo, double q_hi, long lower,
                         std::optional<Count> upper) {
        return collisions::Cell{{{exact(rho_lo), exact(rho_hi)}, {exact(q_lo), exact(q_hi)}}, lower, upper};
    };
    const std::string svg = body_map_svg({cell(0.5, 0.75, 2, 3, 3, 3), cell(0.75, 1, 2, 3, 3, 3),
                                          cell(0.25, 0.26, 4.6, 4.8, 3, 5), cell(0.89, 0.91, 3.2, 3.5, 3, 4),
                                          cell(0.1, 0.2, 50, 60, 0, {})});
    CHECK(well_formed(svg));
    for (const std::string kind : {"n3", "orbit-step", "corner-step", "hatched"}) {
        const std::size_t path = svg.find("<path class=\"" + kind + "\" d=\"M");
        REQUIRE(path != std::string::npos);
        CHECK(count_of(svg.substr(path, svg.find('\n', path) - path), "M") == (kind == "n3" ? 3 : 1));
    }
    CHECK(count_of(svg, "class=\"number roomy\"") == 1);  // the two cells' one name
    CHECK_THAT(svg, Contains("coin") && !Contains("nan") && !Contains("inf"));
}
