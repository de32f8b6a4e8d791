// What the verdict, its paragraph and its JSON say of a claim about the adiabatic invariant, to the letter.
#include <array>

#include "catch.hpp"
#include "verify/wings/adiabatic/grammar.hpp"

namespace adiabatic = dumbbell_verify::adiabatic;

namespace {

adiabatic::Claim claim(adiabatic::Claim::Kind kind) {
    adiabatic::Claim c;
    c.kind = kind;
    c.delta_lo = mpq_class(1, 30);
    c.delta_hi = mpq_class(1, 20);
    c.y_lo = mpq_class(3, 5);
    c.y_hi = mpq_class(9, 10);
    c.margin = mpq_class(2, 3);
    c.exponent = kind == adiabatic::Claim::run ? 0 : 8;
    c.bounds = {mpq_class(20, 3)};
    c.attained = {{mpq_class(11, 10), mpq_class(1, 4), mpq_class(1, 25), 7, mpq_class(3, 7)}};
    return c;
}

}  // namespace

TEST_CASE("adiabatic: a claim about one bounce in words, with two constants") {
    adiabatic::Claim c = claim(adiabatic::Claim::bounce);
    c.exponent = 6;
    c.bounds.emplace_back(9);
    c.attained.push_back({mpq_class(6, 5), 0, mpq_class(1, 24), 1, 0});
    CHECK(c.text() ==
          "claim=adiabatic-bounce delta=1/30:1/20 heights=3/5:9/10 margin=2/3 exponent=6/16 C1=6.666667 "
          "B1=0.428571 at1=1/25 ratio1=15.555556 C2=9.000000 B2=0.000000 at2=1/24");
    CHECK(c.paragraph() ==
          "  For every delta in [1/30, 1/20], beta1 = epsilon = delta^2, and a collision of the light mass "
          "at which\n"
          "  |phidot| = 1 and ydot is in [-delta, 0] before it,\n"
          "  heights y in [3/5, 9/10], the rod at least 2/3 delta^(3/8) from the vertical, and the light "
          "mass collides next:\n"
          "  | |phidot+| - |phidot-| + 2 ydot-/sqrt(1 - y^2) | <= C1 delta^(5/4), C1 = 6.666667,\n"
          "  | y+ - y - 2 (pi - arccos y) ydot-/|phidot-| | <= 2 C2 delta^(13/8), C2 = 9.000000.\n"
          "  Certified for u = 11/10, ydot = -delta s, s = 1/4, delta = 1/25, with 7 collision(s) more:\n"
          "  the same with B1 = 0.428571 and >= instead of C1 and <=; C1/B1 <= 15.555556.\n"
          "  Certified for u = 6/5, ydot = -delta s, s = 0/1, delta = 1/24, with 1 collision(s) more:\n"
          "  the same with B2 = 0.000000 and >= instead of C2 and <=.\n");
    CHECK(
        c.json() ==
        R"({"kind":"adiabatic-bounce","delta":{"lo":"1/30","hi":"1/20"},"heights":{"lo":"3/5","hi":"9/10"},"margin":"2/3","exponent":6,"bounds":["20/3","9/1"],"attained":[{"u":"11/10","s":"1/4","delta":"1/25","collisions":7,"value":"3/7","ratio":"15.555556"},{"u":"6/5","s":"0/1","delta":"1/24","collisions":1,"value":"0/1","ratio":null}]})");
    using Powers = std::array<std::string, 3>;
    for (const auto& [exponent, powers] : {std::pair{0, Powers{"2/3", "C1 delta^2", "C2 delta^2"}},
                                           {1, {"2/3 delta^(1/16)", "C1 delta^(15/8)", "C2 delta^(31/16)"}},
                                           {8, {"2/3 delta^(1/2)", "C1 delta", "C2 delta^(3/2)"}},
                                           {16, {"2/3 delta", "C1", "C2 delta"}}}) {
        c.exponent = static_cast<std::uint64_t>(exponent);
        const std::string text = c.paragraph();
        CHECK(text.find(", the rod at least " + powers[0] + " from the vertical,") < text.size());
        CHECK(text.find(" <= " + powers[1] + ", C1 = 6.666667,") < text.size());
        CHECK(text.find(" <= 2 " + powers[2] + ", C2 = 9.000000.") < text.size());
    }
}

TEST_CASE("adiabatic: a claim about a run in words") {
    adiabatic::Claim c = claim(adiabatic::Claim::run);
    c.delta_lo = 0;
    CHECK(c.text() ==
          "claim=adiabatic-run delta=0/1:1/20 heights=3/5:9/10 margin=2/3 C=6.666667 B=0.428571 at=1/25 "
          "ratio=15.555556");
    CHECK(c.paragraph() ==
          "  For every delta in (0, 1/20], beta1 = epsilon = delta^2, and a collision of the light mass at "
          "which\n"
          "  |phidot| = 1 and ydot is in [-delta, 0] before it,\n"
          "  heights y in [3/5, 9/10]: as long as only the light mass collides, and with the rod at least "
          "2/3 from the vertical,\n"
          "  |I_n - I_0| <= C delta for every number n of further collisions, C = 6.666667; I = |phidot| (pi "
          "- arccos y) before a collision.\n"
          "  Certified for u = 11/10, ydot = -delta s, s = 1/4, delta = 1/25, with 7 collision(s) more:\n"
          "  the same with B = 0.428571 and >= instead of C and <=; C/B <= 15.555556.\n");
    CHECK(
        c.json() ==
        R"({"kind":"adiabatic-run","delta":{"lo":"0/1","hi":"1/20"},"heights":{"lo":"3/5","hi":"9/10"},"margin":"2/3","exponent":null,"bounds":["20/3"],"attained":[{"u":"11/10","s":"1/4","delta":"1/25","collisions":7,"value":"3/7","ratio":"15.555556"}]})");
}

TEST_CASE("adiabatic: a claim about a scattering in words, and of numbers with many digits about which") {
    adiabatic::Claim c = claim(adiabatic::Claim::scattering);
    c.attained[0].u = mpq_class("1234567891/1000000007");
    CHECK(c.text() ==
          "claim=adiabatic-scattering delta=1/30:1/20 margin=2/3 C=6.666667 B=0.428571 at=1/25 "
          "ratio=15.555556");
    CHECK(
        c.paragraph() ==
        "  For every delta in [1/30, 1/20], beta1 = epsilon = delta^2, and a collision of the light mass at "
        "which\n"
        "  |phidot| = 1 and ydot is in [-delta, 0] before it,\n"
        "  the first of a regular trajectory and at u >= 2/3 delta^(1/2), u the rod's distance from the "
        "vertical:\n"
        "  if the last collision is at u >= 2/3 delta^(1/2), too, then |I_N - I_0| <= C delta^(1/2), C = "
        "6.666667,\n"
        "  I = |phidot| (pi - arccos y) before the first and after the last collision; the heavy mass does "
        "not collide.\n"
        "  Certified for u = about 1.234567882, ydot = -delta s, s = 1/4, delta = 1/25, with 7 collision(s) "
        "more:\n"
        "  the same with B = 0.428571 and >= instead of C and <=; C/B <= 15.555556.\n");
    CHECK(
        c.json() ==
        R"({"kind":"adiabatic-scattering","delta":{"lo":"1/30","hi":"1/20"},"heights":null,"margin":"2/3","exponent":null,"bounds":["20/3"],"attained":[{"u":"1234567891/1000000007","s":"1/4","delta":"1/25","collisions":7,"value":"3/7","ratio":"15.555556"}]})");
    c.attained[0].u = mpq_class("1234567891/100000007");
    c.delta_hi = c.delta_lo;
    CHECK(c.text() ==
          "claim=adiabatic-scattering delta=1/30:1/30 margin=2/3 C=6.666667 B=0.428571 ratio=15.555556");
    const std::string text = c.paragraph();
    CHECK(
        text.starts_with("  For delta = 1/30, beta1 = epsilon = delta^2, and a collision of the light mass"));
    CHECK(text.find("  Certified for u = 1234567891/100000007, ydot = -delta s, s = 1/4, ") < text.size());
}
