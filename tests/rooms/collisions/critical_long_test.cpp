#include "collisions/critical_long.hpp"

#include "catch.hpp"
#include "collisions/critical_guess.hpp"
#include "collisions/piece.hpp"
#include "critical_ratio.hpp"
#include "enclosed.hpp"
#include "number/decimal.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

CriticalRatio moved(CriticalRatio ratio, const Rational& below, const Rational& above) {
    ratio.q_lo *= below;
    ratio.q_hi *= above;
    return ratio;
}

}  // namespace

TEST_CASE("a long orbit's critical ratio is where the count recomputed in 80 digits steps up") {
    const long n = first_long;
    const CriticalRatio ratio = enclosed(n, 30);
    CHECK(reference_maximum(ratio.q_lo * (1 - at("1e-33"))) == n - 1);
    CHECK(reference_maximum(ratio.q_hi * (1 + at("1e-33"))) == n);
    CHECK(shared_digits(ratio.q_lo, ratio.q_hi, 30));
}

TEST_CASE("long orbits followed in plain doubles step where their enclosures say") {
    for (const long n : {20'001L, 20'002L, 40'000L, 100'001L}) {
        CAPTURE(n);
        const CriticalRatio ratio = enclosed(n, 15);
        CHECK(std::abs(guess_critical_ratio(n) / ratio.q_lo.convert_to<double>() - 1) < 1e-9);
    }
}

TEST_CASE("enclosures of long orbits that miss the critical ratio, however narrowly, are refused") {
    for (const long n : {20'002L, 1'000'001L}) {
        CAPTURE(n);
        const CriticalRatio ratio = enclosed(n, 20);
        const Rational least = at("1e-19");
        CHECK(certainly_encloses_by_counts(ratio));
        CHECK(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 + least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 - least)));
        CriticalRatio exchanged = moved(ratio, 1 - least, 1 + least);
        std::swap(exchanged.q_lo, exchanged.q_hi);
        CHECK_FALSE(certainly_encloses_by_counts(exchanged));
        for (const long other : {n - 1, n + 1}) {
            CriticalRatio renamed = ratio;
            renamed.n = other;
            CHECK_FALSE(certainly_encloses_by_counts(renamed));
        }
    }
}

TEST_CASE("interval Newton gives the same first long ratio") {
    // `critical 20001 --digits 50` as it was before macro steps.
    const Rational newton = at("509971821.52538596062558050292425816222055680272603");
    const CriticalRatio ratio = enclosed(first_long, 50);
    CHECK((newton <= ratio.q_lo && ratio.q_hi < newton + at("1e-41")));
}

TEST_CASE("more digits of a long orbit's critical ratio begin with the fewer ones") {
    const CriticalRatio few = enclosed(1'000'000, 15);
    const CriticalRatio many = enclosed(1'000'000, 24);
    CHECK(few.q_lo <= many.q_lo);
    CHECK(many.q_hi <= few.q_hi);
    CHECK(to_text(*shared_digits(many.q_lo, many.q_hi, 24)) == "1275051786969.07530004702");
}

TEST_CASE("a guess is as near to the step as it was asked for") {
    const long n = 1'000'000;
    const CriticalRatio ratio = enclosed(n, 20);
    for (const int share_bits : {24, 40}) {
        const auto guess = guess_long_critical_ratio(n, share_bits);
        REQUIRE(guess);
        const Rational step = 2 * ratio.q_lo / n;
        const Rational off = (*guess - ratio.q_lo) / step * Rational(Integer(1) << (share_bits - 5));
        CHECK((off > -1 && off < 1));
    }
    CHECK_FALSE(guess_long_critical_ratio(n, 24, [] { return true; }));
}

TEST_CASE("both sides of a step are decided at a relative distance of 1e-20") {
    // Near 10^18, at the digits of `critical 885595132 --digits 20`.
    const long n = 885'595'132;
    const PieceOptions options = piece_options(Scene::dumbbell, Section::turning);
    const Piece below = prove_single(at("1000000001235988268.9825"), options).piece;
    const Piece above = prove_single(at("1000000001235988269.0026"), options).piece;
    CHECK((below.lower == n - 1 && below.upper == n - 1));
    CHECK((above.lower == n && above.upper == n));
}
