#include "flight/paper_bound.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

using Wide = Decimal<200>;

Wide wide_value(const Rational& q) { return Wide(numerator(q).str()) / Wide(denominator(q).str()); }

/// ceil(pi / gamma) + 1 as the paper writes it; q must not be a tie.
long as_printed(const Rational& q) {
    const Wide pi = pi_in<Wide>();
    const Wide quotient = pi / (pi - 2 * atan(sqrt(wide_value(q))));
    REQUIRE(abs(quotient - round(quotient)) > 1e-150);
    return ceil(quotient).convert_to<long>() + 1;
}

/// cot^2(pi / 2m), where the bound steps from m + 1 to m + 2, moved by `shift` relatively and rounded to a
/// decimal fraction of 60 digits.
Rational near_step(long m, const Wide& shift) {
    const Wide root = 1 / tan(pi_in<Wide>() / (2 * m));
    return parse_rational((root * root * (1 + shift)).str(100, std::ios_base::fixed).substr(0, 100));
}

}  // namespace

TEST_CASE("The paper's bound at round mass ratios") {
    // A table computed from the printed formula elsewhere (20 digits).
    CHECK(paper_bound(1) == 3);
    CHECK(paper_bound(3) == 4);
    CHECK(paper_bound(2) == 4);
    CHECK(paper_bound(10) == 7);
    CHECK(paper_bound(100) == 17);
    CHECK(paper_bound(1000) == 51);
    CHECK(paper_bound(10'000) == 159);
    CHECK(paper_bound(1'000'000) == 1572);
    for (const char* q :
         {"1.1", "1.0000001", "4.6", "4.61", "9/2", "12", "25", "99999", "1e8", "1e12", "1e20", "1e30"}) {
        CAPTURE(q);
        CHECK(paper_bound(parse_rational(q)) == as_printed(parse_rational(q)));
    }
}

TEST_CASE("The paper's bound agrees with the printed formula at random ratios") {
    Random random(141);
    for (int i = 0; i < 1000; ++i) {
        const Rational q = exact(random.scaled(1, 1e9));
        if (q != 1 && paper_bound(q) != as_printed(q)) {
            FAIL(say("q =", to_fraction(q), "bound", paper_bound(q), "printed", as_printed(q)));
        }
    }
}

TEST_CASE("The ties q = 1 and q = 3 are exact, their neighbours are not on them") {
    const Rational hair = parse_rational("1e-900");
    CHECK(paper_bound(1) == 3);
    CHECK(paper_bound(1 + hair) == 4);
    CHECK(paper_bound(3 - hair) == 4);
    CHECK(paper_bound(3) == 4);
    CHECK(paper_bound(3 + hair) == 5);
    CHECK(paper_bound(Rational(6, 2)) == 4);
}

TEST_CASE("Just below a step cot^2(pi/2m) the bound is m + 1, just above m + 2") {
    for (const long m : {4L, 5L, 6L, 7L, 10L, 51L, 158L, 1571L}) {
        for (const char* relative : {"1e-3", "1e-12", "1e-40", "1e-80"}) {
            CAPTURE(m, relative);
            CHECK(paper_bound(near_step(m, -Wide(relative))) == m + 1);
            CHECK(paper_bound(near_step(m, Wide(relative))) == m + 2);
        }
    }
}

TEST_CASE("Steps are found where doubles cannot count any more") {
    Random random(142);
    for (int i = 0; i < 100; ++i) {
        const long m = std::lround(random.scaled(1e14, 4e15));
        CAPTURE(m);
        CHECK(paper_bound(near_step(m, Wide("-1e-25"))) == m + 1);
        CHECK(paper_bound(near_step(m, Wide("1e-25"))) == m + 2);
    }
}

TEST_CASE("Below 1 there is no bound to give") {
    CHECK_THROWS_AS(paper_bound(Rational(1, 2)), BrokenInvariant);
    CHECK_THROWS_AS(paper_bound(0), BrokenInvariant);
    CHECK_THROWS_AS(paper_bound(-3), BrokenInvariant);
}
