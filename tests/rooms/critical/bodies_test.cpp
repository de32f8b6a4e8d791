// Where N of bodies steps: between what certificates of both sides say.
#include "critical/bodies.hpp"

#include "catch.hpp"
#include "collisions/certify.hpp"
#include "number/decimal.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::critical;

namespace {

std::string step(const Rational& rho, long n, int digits = 15) {
    const auto ratio = enclose_inertia({rho}, n, {.digits = digits});
    REQUIRE(ratio);
    return to_text(*shared_digits(ratio->q_lo, ratio->q_hi, digits));
}

/// As certify has it, of which nothing here is used.
Count certified(const Bodies& bodies, const Rational& t) {
    const Piece piece = certify({.claim = bodies.at(t)}).front().piece;
    REQUIRE(piece.status() == Status::exact);
    return piece.lower;
}

void check_ends(const Bodies& bodies, const Ratio& ratio) {
    CAPTURE(ratio.q_lo, ratio.q_hi);
    CHECK(certified(bodies, bodies.have_rods ? ratio.q_hi : ratio.q_lo) == ratio.below);
    CHECK(certified(bodies, bodies.have_rods ? ratio.q_lo : ratio.q_hi) == ratio.n);
}

}  // namespace

TEST_CASE("Steps at one rho, by each of the motions of Theorem B, and by the corner") {
    CHECK(step(Rational(1, 2), 4) == "6.37228132326901");   // the corner
    CHECK(step(Rational(1, 2), 5) == "6.63870282897848");   // a tangent
    CHECK(step(Rational(1, 10), 4) == "6.42461837317772");  // the even motion
    CHECK(step(Rational(3, 20), 5) == "6.66666666666666");  // on the edge, Q rho = 1, where k0 = k1
    CHECK(step(Rational(1, 2), 5, 100).starts_with("6.638702828978480381645032167998522444565224619266"));
    const Bodies quarter{Rational(1, 4)};
    for (const long n : {4L, 5L}) {
        const Ratio ratio = *enclose_inertia(quarter, n, {});
        CHECK((ratio.below == 3 && ratio.n == 5));  // it leaps over 4
        check_ends(quarter, ratio);
    }
}

TEST_CASE("Symmetric bodies step at cot^2(pi/(2 (n - 1))), the first two exactly") {
    CHECK((step(1, 3) == "1.00000000000000" && step(1, 4) == "3.00000000000000"));
    CHECK(step(1, 5, 30) == "5.82842712474619009760337744841");  // 3 + 2 sqrt 2
    CHECK(enclose_inertia({Rational(1)}, 4, {})->q_lo == 3);
}

TEST_CASE("Beside a step certify decides both sides, with as many bits as it takes") {
    for (const int digits : {12, 20, 40}) {
        for (const Rational& rho : {Rational(1, 10), Rational(1, 2)}) {
            for (const long n : {4L, 7L}) {
                check_ends({rho}, *enclose_inertia({rho}, n, {.digits = digits}));
            }
        }
    }
}

TEST_CASE("The mass of a rod at which N falls, each side decided") {
    for (const auto& [ratio, masses] : std::vector<std::pair<long, std::vector<const char*>>>{
             {10, {"0.530596"}}, {100, {"0.00683272", "0.0366507", "0.130116", "1.02921"}}}) {
        const Bodies rods{ratio, true};
        const auto falls = enclose_falls(rods, {.digits = 6});
        REQUIRE(falls.size() == masses.size());
        for (std::size_t i = 0; i < falls.size(); ++i) {
            REQUIRE(falls[i].ratio);
            CHECK(to_text(*shared_digits(falls[i].ratio->q_lo, falls[i].ratio->q_hi, 6)) == masses[i]);
            check_ends(rods, *falls[i].ratio);
        }
    }
}

TEST_CASE("No step and no fall is enclosed by one that is asked to stop") {
    CHECK_FALSE(enclose_inertia({Rational(1, 2)}, 5, {.interrupted = [] { return true; }}));
    CHECK_FALSE(enclose_falls({10, true}, {.interrupted = [] { return true; }}).back().ratio);
}
