#include "collisions/witness.hpp"

#include "catch.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

constexpr long no_cap = 1'000'000;

std::optional<Witness> checked(const char* e, const char* eta, const char* q_lo, const char* q_hi,
                               long cap = no_cap) {
    const auto value = [](const char* text) {
        return text[0] == '-' ? -parse_rational(text + 1) : parse_rational(text);
    };
    return checked_witness<Interval>(value(e), value(eta), value(q_lo), value(q_hi), cap);
}

// No certified count may exceed the recomputed one, at the ends of the range and inside it.
template <class I>
void check_counts(const Witness& w, const Rational& q_lo, const Rational& q_hi, Random& choices) {
    for (const Rational& q : {q_lo, q_hi, Rational(q_lo + (q_hi - q_lo) * exact(choices.uniform(0, 1)))}) {
        CAPTURE(w.e, w.eta, q_lo, q_hi, q);
        const Sides sides = bridge_counts(w.e, w.eta, q);
        REQUIRE(w.forward <= sides.forward);
        REQUIRE(w.backward <= sides.backward);
    }
}

}  // namespace

TEST_CASE("a contact must lie between the corner and the top of the bridge") {
    CHECK(checked("1/2", "1/2", "10", "10").has_value());
    CHECK_FALSE(checked("0", "1/2", "10", "10").has_value());
    CHECK_FALSE(checked("-1/2", "1/2", "10", "10").has_value());
    CHECK_FALSE(checked("2", "1/2", "10", "10").has_value());
    CHECK_FALSE(checked("1.5707963267948967", "1/2", "10", "10").has_value());  // just above pi/2
    CHECK(checked("1.570796326794", "1/2", "10", "10").has_value());
}

TEST_CASE("the ray must leave above the tangent: transversally") {
    CHECK_FALSE(checked("1/2", "0", "10", "10").has_value());
    CHECK_FALSE(checked("1/2", "-1/1000", "10", "10").has_value());
    CHECK(checked("1/2", "1e-300", "10", "10").has_value());
}

TEST_CASE("the outgoing ray must be less steep than one at the least ratio of the range") {
    CHECK(checked("3/2", "9", "10", "10").has_value());
    CHECK_FALSE(checked("3/2", "10", "10", "10").has_value());
    CHECK_FALSE(checked("3/2", "9", "9", "10").has_value());
    CHECK_FALSE(checked("1/1000", "1/2", "1.2", "1.2").has_value());  // (1 + 1/2) / 1.2 > 1
}

TEST_CASE("so near the corner that doubles cannot see the reversed ray pass above it, more bits can") {
    const Rational e(1, Integer(1) << 30U);
    CHECK_FALSE(checked_witness<Interval>(e, e * e * e, 10, 10, no_cap).has_value());
    const PrecisionScope scope(256);
    CHECK(checked_witness<BigInterval>(e, e * e * e, 10, 10, no_cap).has_value());
}

TEST_CASE("counts stop at the cap") {
    const auto all = checked("1/2", "1/8", "100", "100");
    REQUIRE(all.has_value());
    REQUIRE(all->forward > 2);
    const auto capped = checked("1/2", "1/8", "100", "100", 2);
    REQUIRE(capped.has_value());
    CHECK(capped->forward == 2);
    CHECK(capped->backward == 2);
    CHECK(capped->total() == 5);
}

TEST_CASE("certified counts of random contacts never exceed a recomputation in 80 digits") {
    Random choices(21);
    int certain = 0;
    for (int i = 0; i < 400; ++i) {
        const double q = choices.log_uniform(1, choices.coin() ? 20 : 400);
        const Rational q_lo = exact(q);
        const Rational q_hi = choices.coin() ? q_lo : exact(q * (1 + choices.log_uniform(1e-9, 0.3)));
        const double e = choices.coin() ? choices.log_uniform(1e-9, 1.57)
                                        : 1.5707963267948966 - choices.log_uniform(1e-12, 1.5);
        const Rational eta = exact(choices.log_uniform(1e-18, 2));
        if (const auto w = checked_witness<Interval>(exact(e), eta, q_lo, q_hi, no_cap)) {
            certain += w->total() >= 3 ? 1 : 0;
            check_counts<Interval>(*w, q_lo, q_hi, choices);
        }
    }
    CHECK(certain > 150);
}

TEST_CASE("at a single ratio the certified counts are the true ones, but for contacts at a tangency") {
    Random choices(22);
    int missed = 0;
    for (int i = 0; i < 200; ++i) {
        const Rational q = exact(choices.log_uniform(1.1, 300));
        const Rational e = exact(choices.uniform(0.01, 1.57));
        const Rational eta = exact(choices.log_uniform(1e-3, 0.05));
        const auto w = checked_witness<Interval>(e, eta, q, q, no_cap);
        REQUIRE(w.has_value());
        const Sides sides = bridge_counts(e, eta, q);
        missed += sides.forward != w->forward || sides.backward != w->backward ? 1 : 0;
    }
    CHECK(missed == 0);
}

TEST_CASE("just above a critical ratio the search still finds the new maximum") {
    for (const long n : {4L, 5L, 6L, 7L, 20L, 21L}) {
        for (const char* distance : {"1e-4", "1e-6", "1e-9"}) {
            const Rational q = critical_ratio(n) * (1 + parse_rational(distance));
            CAPTURE(n, distance);
            const auto w = find_witness<Interval>(q, q, n);
            REQUIRE(w.has_value());
            CHECK(bridge_counts(w->e, w->eta, q).forward >= w->forward);
            CHECK(bridge_counts(w->e, w->eta, q).backward >= w->backward);
            const Rational below = critical_ratio(n) * (1 - parse_rational(distance));
            CHECK_FALSE(find_witness<Interval>(below, below, n).has_value());
        }
    }
}

TEST_CASE("with 256 bits the search reaches 1e-25 above a critical ratio") {
    const PrecisionScope scope(256);
    for (const long n : {4L, 5L}) {
        const Rational q = critical_ratio(n) * (1 + parse_rational("1e-25"));
        const auto w = find_witness<BigInterval>(q, q, n);
        REQUIRE(w.has_value());
        CHECK(w->total() >= n);
    }
}

TEST_CASE("one contact serves a whole range between two critical ratios") {
    for (const long n : {4L, 5L, 8L, 9L}) {
        const Rational lo = critical_ratio(n) * (1 + parse_rational("1e-6"));
        const Rational hi = critical_ratio(n + 1);
        const auto w = find_witness<Interval>(lo, hi, n);
        REQUIRE(w.has_value());
        Random choices(24);
        check_counts<Interval>(*w, lo, hi, choices);
    }
}
