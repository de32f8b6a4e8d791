#include "pictures/svg.hpp"

#include "catch.hpp"
#include "xml.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;
using namespace dumbbell_test;

TEST_CASE("a length has two decimals at most, and no zeros at its end") {
    CHECK(px(12) == "12");
    CHECK(px(100) == "100");
    CHECK(px(12.5) == "12.5");
    CHECK(px(12.345) == "12.35");
    CHECK(px(-0.001) == "0");
    CHECK(px(-7.25) == "-7.25");
}

TEST_CASE("words may hold what XML gives a meaning") {
    CHECK(xml_text("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
    Svg svg(10, 10, "1 < 2 & 3");
    svg.text(1, 2, "<text>&amp;", Anchor::end);
    svg.upright_text(1, 2, "\"upright\"");
    CHECK(well_formed(svg.finished()));
    CHECK_THAT(svg.finished(),
               Contains("<title>1 &lt; 2 &amp; 3</title>") && Contains("&lt;text&gt;&amp;amp;"));
}

TEST_CASE("letters of two bytes are as wide as others") {
    CHECK(text_width("\xcf\x80\xcf\x80") == text_width("pi"));
}

TEST_CASE("every element makes a well-formed page, and the same calls give the same bytes") {
    const auto drawn = [] {
        Svg svg(200, 100, "all");
        svg.colour("kind", "fill", {"#123", "#fed"});
        svg.rules(".kind{stroke-width:2}");
        svg.open_clip(0, 0, 50, 50);
        svg.line("kind", 0, 0, 1, 1);
        svg.circle("kind", 0, 0, 1);
        svg.close();
        svg.open_units(10, 20, 0.5, -0.25);
        svg.path("kind", "M0 0h1v1z");
        svg.close();
        svg.open_clip(0, 0, 20, 20);
        svg.rect("kind", 0, 0, 1, 1);
        svg.close();
        return svg.finished();
    };
    CHECK(well_formed(drawn()));
    CHECK(drawn() == drawn());
    CHECK_THAT(drawn(), Contains("clip1") && Contains("clip2") && Contains("scale(0.5 -0.25)"));
}

TEST_CASE("a colour is one of the light page, and another where the reader prefers dark") {
    Svg svg(10, 10, "colours");
    svg.colour("kind", "fill", {"#123456", "#fedcba"});
    const std::string text = svg.finished();
    const std::size_t dark = text.find("@media (prefers-color-scheme:dark)");
    REQUIRE(dark != std::string::npos);
    CHECK(text.find(".kind{fill:#123456}") < dark);
    CHECK(text.find(".kind{fill:#fedcba}") > dark);
    CHECK(text.find(".kind{fill:#fedcba}") != std::string::npos);
}

TEST_CASE("only what is hatched defines the hatching") {
    Svg svg(10, 10, "hatched");
    CHECK_THAT(svg.finished(), !Contains("<pattern"));
    svg.rect("hatched", 0, 0, 1, 1);
    CHECK_THAT(svg.finished(), Contains("<pattern id=\"hatch\""));
    CHECK(well_formed(svg.finished()));
}
