#include "collisions/cover.hpp"

#include <algorithm>

#include "catch.hpp"
#include "collisions/writer.hpp"
#include "critical_ratio.hpp"
#include "number/parallel.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

constexpr std::array charts{Chart::bridge, Chart::light};

// Follows the pre-order tree over its boxes and judges every leaf again; returns where the subtree ends.
std::size_t walk(const Tree& tree, std::size_t at, Chart chart, const Box& box, long upper) {
    REQUIRE(at < tree.size());
    const Node& node = tree[at];
    if (node.split) {
        const auto [lower, upper_half] = halves(box, *node.split);
        const std::size_t middle = walk(tree, at + 1, chart, lower, upper);
        return walk(tree, middle, chart, upper_half, upper);
    }
    const auto again = judge<Interval>(chart, box, upper);
    REQUIRE(again.has_value());
    REQUIRE(again->reason == node.leaf.reason);
    REQUIRE(again->forward == node.leaf.forward);
    REQUIRE(again->backward == node.leaf.backward);
    return at + 1;
}

void check_closes(const Rational& lo, const Rational& hi, long upper) {
    CAPTURE(lo, hi, upper);
    for (const Chart chart : charts) {
        const auto tree = cover<Interval>(chart, lo, hi, upper, CoverOptions{});
        REQUIRE(tree.has_value());
        CHECK(walk(*tree, 0, chart, root_box(chart, lo, hi), upper) == tree->size());
    }
}

std::string spelled(const Tree& tree) {
    Piece piece;
    piece.upper = 2;
    piece.q_lo = piece.q_hi = 1;
    piece.cover.charts = {{Chart::light, tree}};
    return render({{"test", "1"}, {piece}}).text;
}

}  // namespace

TEST_CASE("both charts close with the true maximum, and the tree is complete and in pre-order") {
    for (const char* text : {"1.0000001", "1.000000000001", "1.1", "4.6", "4.61", "10", "12", "11.36", "100",
                             "1000", "1e4", "1e6"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        check_closes(q, q, reference_maximum(q));
    }
}

TEST_CASE("both charts close on either side of a critical ratio, at distances from 1e-4 to 1e-9") {
    for (const long n : steps({4, 5, 8, 31}, {6, 7, 9, 20, 100})) {
        for (const char* distance : {"1e-4", "1e-6", "1e-9"}) {
            const Rational d = parse_rational(distance);
            const Rational below = critical_ratio(n) * (1 - d);
            const Rational above = critical_ratio(n) * (1 + d);
            check_closes(below, below, n - 1);
            check_closes(above, above, n);
        }
    }
}

TEST_CASE("a range of ratios closes with one value between two critical ratios, and only there") {
    const Rational margin = parse_rational("1e-6");
    for (const long n : steps({4, 5, 12}, {6, 7, 13, 40})) {
        const Rational lo = critical_ratio(n) * (1 + margin);
        const Rational hi = critical_ratio(n + 1) * (1 - margin);
        check_closes(lo, hi, n);
        const Rational beyond = critical_ratio(n + 1) * (1 + margin);
        check_closes(lo, beyond, n + 1);
        CHECK_FALSE(
            cover<Interval>(Chart::bridge, lo, beyond, n, CoverOptions{.max_nodes = 2000}).has_value());
    }
}

TEST_CASE("near a ratio of one every range closes with three") {
    check_closes(1, parse_rational("1.000001"), 3);
    check_closes(1, parse_rational("1.5"), 3);
}

TEST_CASE("the whole is closed in higher precision just below the place where doubles end") {
    const PrecisionScope scope(256);
    const Rational q = critical_ratio(4) * (1 - parse_rational("1e-30"));
    for (const Chart chart : charts) {
        CHECK(cover<BigInterval>(chart, q, q, 3, CoverOptions{}).has_value());
    }
    CHECK_FALSE(cover<Interval>(Chart::bridge, q, q, 3, CoverOptions{.max_nodes = 2000}).has_value());
}

TEST_CASE("few leaves of a range's cover count: a box is split in the axis that keeps it open") {
    const Rational near = parse_rational("1e-6");
    for (const long n : steps({5, 22}, {6, 21})) {
        const auto tree = cover<Interval>(Chart::light, critical_ratio(n) * (1 + near),
                                          critical_ratio(n + 1) * (1 - near), n, CoverOptions{});
        REQUIRE(tree.has_value());
        CHECK(std::count_if(tree->begin(), tree->end(), [](const Node& node) {
                  return !node.split && node.leaf.reason == Reason::count;
              }) <= 6);
    }
}

TEST_CASE("the tree is the same for 1, 2 and 8 threads") {
    const Rational q = 10;
    const CoverOptions options{.parallel = true};
    const auto serial = cover<Interval>(Chart::plain_departure, q, q, 4, CoverOptions{});
    REQUIRE(serial.has_value());
    REQUIRE(serial->size() > 1000);
    for (const int threads : {1, 2, 8}) {
        for (int repeat = 0; repeat < 3; ++repeat) {
            const auto tree = with_threads(
                threads, [&] { return cover<Interval>(Chart::plain_departure, q, q, 4, options); });
            REQUIRE(tree.has_value());
            CHECK(spelled(*tree) == spelled(*serial));
        }
    }
}

TEST_CASE("worker threads compute with the caller's precision") {
    // So close to the critical ratio that 53 bits do not close all boxes of the sharp bound of this chart.
    const Rational q = critical_ratio(7) * (1 - parse_rational("1e-18"));
    const auto tree_with = [&](int bits, bool parallel) {
        const PrecisionScope scope(bits);
        const CoverOptions options{.max_nodes = 2000, .parallel = parallel};
        return cover<BigInterval>(Chart::light, q, q, 5, options);
    };
    CHECK_FALSE(tree_with(53, false).has_value());
    const auto serial = tree_with(100, false);
    REQUIRE(serial.has_value());
    CHECK(serial->size() > 2);
    const auto parallel = with_threads(8, [&] { return tree_with(100, true); });
    REQUIRE(parallel.has_value());
    CHECK(spelled(*parallel) == spelled(*serial));
}

TEST_CASE("in higher precision a box that doubles close is closed as they close it") {
    const Rational q = critical_ratio(7) * (1 - parse_rational("1e-6"));
    const PrecisionScope scope(128);
    for (const Chart chart : {Chart::bridge, Chart::light}) {
        const auto in_double = cover<Interval>(chart, q, q, 6, CoverOptions{});
        const auto in_128 = cover<BigInterval>(chart, q, q, 6, CoverOptions{});
        REQUIRE((in_double.has_value() && in_128.has_value()));
        CHECK(spelled(*in_double) == spelled(*in_128));
    }
}

TEST_CASE("the search gives up beyond its nodes, its depth, or when it is interrupted") {
    const Rational q = critical_ratio(7) * (1 - parse_rational("1e-6"));
    const CoverOptions plenty{};
    const auto tree = cover<Interval>(Chart::light, q, q, 6, plenty);
    REQUIRE(tree.has_value());
    CoverOptions exactly = plenty;
    exactly.max_nodes = tree->size();
    CHECK(cover<Interval>(Chart::light, q, q, 6, exactly).has_value());
    exactly.max_nodes -= 1;
    CHECK_FALSE(cover<Interval>(Chart::light, q, q, 6, exactly).has_value());
    CHECK_FALSE(cover<Interval>(Chart::light, q, q, 6, CoverOptions{.max_depth = 2}).has_value());
    CHECK_FALSE(
        cover<Interval>(Chart::light, q, q, 6, CoverOptions{.interrupted = [] { return true; }}).has_value());
}
