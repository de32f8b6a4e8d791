#include "law/at_ratio.hpp"

#include <tuple>

#include "base/error.hpp"
#include "catch.hpp"
#include "critical/enclose.hpp"
#include "law/constants.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::law;

namespace {

AtRatio at_ratio(const Rational& q) {
    static const auto steps = read_steps(DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    return law_at(q, steps);
}

}  // namespace

TEST_CASE("below the theorem's ratios the law is that of its certificate's steps") {
    for (const auto& [text, lower, upper] :
         std::vector<std::tuple<const char*, long, long>>{{"1", 2, 2},
                                                          {"1.000000000000000000000000000001", 3, 3},
                                                          {"32/7", 3, 3},
                                                          {"4.6", 3, 4},
                                                          {"24/5", 4, 4},
                                                          {"10", 4, 4},
                                                          {"62.6", 8, 8},
                                                          {"62.7", 8, 9},
                                                          {"62.75", 9, 9},
                                                          {"1032803", 901, 901},
                                                          {"1032804", 901, 902},
                                                          {"1032809.5", 902, 902}}) {
        CAPTURE(text);
        const AtRatio at = at_ratio(parse_rational(text));
        CHECK(at.lower == Integer(lower));
        CHECK(at.upper == Integer(upper));
        CHECK((at.lower == at.upper) == (exact_lo(at.past) >= 0 || exact_hi(at.past) <= 0));
    }
}

TEST_CASE("all steps of the shipped certificate are read, and nothing else as one") {
    const auto steps = read_steps(DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    REQUIRE(std::ssize(steps) == last_step - first_step + 1);
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        CHECK(steps[i].below < steps[i].above);
        CHECK(steps[i].above < steps[i + 1].below);
    }
    CHECK_THROWS_AS(read_steps(DUMBBELL_PROJECT "/certificates/q-10.dbc"), InputError);
}

TEST_CASE("the law reaches as far as one can write ratios") {
    const AtRatio at = at_ratio(parse_rational("1e100"));
    CHECK(at.lower == at.upper);
    CHECK(at.lower.str() == "88559512945271391141202194891455767300579529460287");
    CHECK(width(at.past) < 1e-45);
    // C to as many digits (rooms/verify/wings/law/constants_test.cpp has them from a series of its own).
    CHECK(at_ratio(parse_rational("1e200")).lower.str() ==
          "88559512945271391141202194891455767300579529460285208340726080557816077824860635006196282336302454"
          "06");
    const AtRatio third = at_ratio(parse_rational("1e300") / 3);
    CHECK(third.lower == third.upper);
    if (scaled(1) < 20) return;  // 1,000 digits take a second
    const AtRatio greatest = at_ratio(parse_rational("1e1000"));
    CHECK(greatest.lower == greatest.upper);
    CHECK(greatest.lower.str().starts_with("8855951294527139114120219489145576730057952946028520834"));
    CHECK(greatest.lower.str().size() == 500);
}

TEST_CASE("critical ratios by the law contain those of the orbits, and are as narrow as it says") {
    for (const long n : {903L, 904L, 2001L, 5002L}) {
        CAPTURE(n);
        const BigInterval by_law = critical_ratio(Integer(n));
        const auto by_orbit = critical::enclose_ratio(n, {.digits = 20});
        REQUIRE(by_orbit);
        CHECK(exact_lo(by_law) <= by_orbit->q_lo);
        CHECK(by_orbit->q_hi <= exact_hi(by_law));
        // delta is known to (0.22 + 5.2 q^(-1/4)) q^(-1/2), and q = (place/C)^2.
        const double q = approximate(by_law);
        CHECK(width(by_law) <= 2 / 0.8855 * (0.221 + 5.2 / std::sqrt(std::sqrt(q))));
    }
}
