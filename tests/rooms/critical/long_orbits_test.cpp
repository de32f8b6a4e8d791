#include "critical/long_orbits.hpp"

#include "catch.hpp"
#include "collisions/fine_step.hpp"
#include "collisions/step_guess.hpp"
#include "enclosed.hpp"
#include "number/decimal.hpp"
#include "rooms/collisions/critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::critical;
using namespace dumbbell_test;

namespace {

Ratio moved(Ratio ratio, const Rational& below, const Rational& above) {
    ratio.q_lo *= below;
    ratio.q_hi *= above;
    return ratio;
}

}  // namespace

TEST_CASE("a long orbit's critical ratio is where the count recomputed in 80 digits steps up") {
    const long n = first_long;
    const Ratio ratio = enclosed(n, 30);
    CHECK(reference_maximum(ratio.q_lo * (1 - at("1e-33"))) == n - 1);
    CHECK(reference_maximum(ratio.q_hi * (1 + at("1e-33"))) == n);
    CHECK(shared_digits(ratio.q_lo, ratio.q_hi, 30));
}

TEST_CASE("long orbits followed in plain doubles step where their enclosures say") {
    for (const long n : {20'001L, 20'002L, 40'000L, 100'001L}) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 15);
        CHECK(std::abs(guess_step(n) / ratio.q_lo.convert_to<double>() - 1) < 1e-9);
    }
}

TEST_CASE("enclosures of long orbits that miss the critical ratio, however narrowly, are refused") {
    for (const long n : {20'002L, 1'000'001L}) {
        CAPTURE(n);
        const Ratio ratio = enclosed(n, 20);
        const Rational least = at("1e-19");
        CHECK(certainly_encloses_by_counts(ratio));
        CHECK(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 + least, 1 + least)));
        CHECK_FALSE(certainly_encloses_by_counts(moved(ratio, 1 - least, 1 - least)));
        Ratio exchanged = moved(ratio, 1 - least, 1 + least);
        std::swap(exchanged.q_lo, exchanged.q_hi);
        CHECK_FALSE(certainly_encloses_by_counts(exchanged));
        for (const long other : {n - 1, n + 1}) {
            Ratio renamed = ratio;
            renamed.n = other;
            CHECK_FALSE(certainly_encloses_by_counts(renamed));
        }
    }
}

TEST_CASE("interval Newton gives the same first long ratio") {
    // `critical 20001 --digits 50` as it was before macro steps.
    const Rational newton = at("509971821.52538596062558050292425816222055680272603");
    const Ratio ratio = enclosed(first_long, 50);
    CHECK((newton <= ratio.q_lo && ratio.q_hi < newton + at("1e-41")));
}

TEST_CASE("more digits of a long orbit's critical ratio begin with the fewer ones") {
    const Ratio few = enclosed(1'000'000, 15);
    const Ratio many = enclosed(1'000'000, 24);
    CHECK(few.q_lo <= many.q_lo);
    CHECK(many.q_hi <= few.q_hi);
    CHECK(to_text(*shared_digits(many.q_lo, many.q_hi, 24)) == "1275051786969.07530004702");
}
