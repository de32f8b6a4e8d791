// The bug to hunt: a cover that closes a false claim. Every longest trajectory touches the bridge once, so
// the bridge chart has states with N collisions at every ratio, and no tree may close it for N - 1.
#include "catch.hpp"
#include "collisions/cover.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

std::vector<Rational> hard_ratios() {
    std::vector<Rational> ratios;
    for (const char* text :
         steps<const char*>({"1.0000001", "1.1", "3", "4.6", "4.61", "10", "11.36", "11.37", "100"},
                            {"2", "9/2", "12", "20", "25", "50", "137", "400", "1000", "5000", "10000"})) {
        ratios.push_back(parse_rational(text));
    }
    for (const long n : steps({4, 5, 9}, {6, 30})) {
        ratios.push_back(critical_ratio(n) * (1 - parse_rational("1e-6")));
        ratios.push_back(critical_ratio(n) * (1 + parse_rational("1e-6")));
    }
    return ratios;
}

template <class I>
bool closes(const Rational& lo, const Rational& hi, long upper, std::size_t max_nodes) {
    return cover<I>(Chart::bridge, lo, hi, upper, {.max_nodes = max_nodes}).has_value();
}

}  // namespace

TEST_CASE("the cover fails on N-1 at single ratios") {
    for (const Rational& q : hard_ratios()) {
        const long n = reference_maximum(q);
        CAPTURE(q, n);
        CHECK_FALSE(closes<Interval>(q, q, n - 1, 2000));
    }
}

TEST_CASE("nor does it close with many more boxes, or in higher precision") {
    for (const char* text : {"4.7", "10", "11.37", "100"}) {
        const Rational q = parse_rational(text);
        const long n = reference_maximum(q);
        CAPTURE(text, n);
        CHECK_FALSE(closes<Interval>(q, q, n - 1, 10000));
        const PrecisionScope scope(128);
        CHECK_FALSE(closes<BigInterval>(q, q, n - 1, 1000));
    }
}

TEST_CASE("the cover fails on N-1 over ranges that reach beyond a critical ratio by 1e-9") {
    for (const long n : steps({4, 5, 16}, {6, 7, 8, 15, 50})) {
        const Rational hi = critical_ratio(n) * (1 + parse_rational("1e-9"));
        const Rational lo = critical_ratio(n) * parse_rational("0.99");
        CAPTURE(n);
        CHECK_FALSE(closes<Interval>(lo, hi, n - 1, 2000));
    }
}

TEST_CASE("with one collision less no box around a witness's contact closes either") {
    // However small the box: its states really have N collisions.
    const Rational q = 100;
    const Rational e = Rational(1, 8);
    Rational eta = Rational(1, 64);
    while (1 + bridge_counts(e, eta, q).forward + bridge_counts(e, eta, q).backward < 10) {
        eta /= 2;
        REQUIRE(eta > Rational(1, 1 << 20));
    }
    for (int k = 4; k < 40; ++k) {
        const Rational half = Rational(1, Integer(1) << static_cast<unsigned>(k)) * eta;
        const Box box{e - half, e + half, eta - half, eta + half, q, q};
        CHECK_FALSE(judge<Interval>(Chart::bridge, box, 9));
    }
}
