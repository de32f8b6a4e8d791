#include "starts/answer/trace.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "starts/air/box_state.hpp"
#include "starts/air/flight.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

Box typed(const std::string& phi, const std::string& phidot, const std::string& y, const std::string& ydot,
          const std::string& q = "10") {
    return dumbbell_trace_test::point(parse_signed_rational(phi), parse_signed_rational(phidot),
                                      parse_signed_rational(y), parse_signed_rational(ydot),
                                      parse_signed_rational(q));
}

Box with(Box box, Axis axis, const std::string& lo, const std::string& hi) {
    box.lo[static_cast<std::size_t>(axis)] = parse_signed_rational(lo);
    box.hi[static_cast<std::size_t>(axis)] = parse_signed_rational(hi);
    return box;
}

bool contains(const TracedValue& value, double x) {
    return value.outward.lo() <= x && x <= value.outward.hi();
}

}  // namespace

TEST_CASE("A rod that falls without turning touches with the lower mass") {
    // Upright, the heavy mass below: it touches when y = beta1 = 1/11, and flies back up for good.
    const Trace heavy = trace(typed("0.5", "0", "3", "-1"), 0);
    REQUIRE(heavy.collisions.size() >= 1);
    CHECK(heavy.collisions[0].heavy);
    CHECK(contains(heavy.collisions[0].time, 3 - std::sin(0.5) / 11));
    const Trace light = trace(typed("-0.5", "0", "3", "-1"), 0);
    REQUIRE(light.collisions.size() >= 1);
    CHECK(!light.collisions[0].heavy);
    CHECK(contains(light.collisions[0].time, 3 - std::sin(0.5) * 10 / 11));
}

TEST_CASE("An ascending start has no collision when it leaves, and its collisions when it does not") {
    CHECK(trace(typed("1", "1", "0.5", "1"), 0).most == 0);     // steeper than 1 per radian
    CHECK(trace(typed("1", "5", "1.5", "0.01"), 0).most == 0);  // above everything
    CHECK(trace(typed("1", "5", "1.5", "0"), 0).most == 0);
    CHECK(trace(typed("1", "-1", "0.9", "0.1"), 0).most == 0);  // clears the light wall's peak
    const Trace low = trace(typed("1", "1", "0.3", "0"), 0);    // horizontal, into the light wall
    CHECK(low.exact());
    CHECK(low.least >= 1);
}

TEST_CASE("Many turns of the rod before the first contact are followed") {
    const Trace fast = trace(typed("1", "300", "2", "-1"), 0);
    CHECK(fast.exact());
    REQUIRE(fast.collisions.size() >= 1);
    CHECK(fast.collisions[0].time.outward.lo() > 1);
    CHECK(trace(typed("1", "300", "2", "-1"), 30).exact());
}

TEST_CASE("The proof of a first flight asks at each span whether to end, and then the trace ends at once") {
    // So near to a corner the last spans are as short as 2^-450.
    const auto start =
        dumbbell_trace_test::point(Rational(-1) + Rational(1) / pow(Integer(2), 900), 1, 1, -1, 10);
    long asked = 0, patience = 1'000'000;
    const Interrupted question = [&] { return ++asked > patience; };
    const Trace all = trace(start, 300, nobody, question);
    REQUIRE(asked > 500);
    for (patience = 0; patience < 500; patience += 100) {
        asked = 0;
        const Trace none = trace(start, 300, nobody, question);
        CHECK(asked < patience + 10);
        CHECK(none.collisions.empty());
        CHECK((none.least <= all.least && !none.most));
    }
}

TEST_CASE("What is shown of a trace that is interrupted after its last collision is no whole trace") {
    const auto start = typed("1/3", "1", "3", "-1/2");
    long asked = 0, patience = 1'000'000;
    const Interrupted question = [&] { return ++asked > patience; };
    REQUIRE(trace(start, 30, nobody, question).exact());
    patience = asked - 1;
    asked = 0;
    CHECK_FALSE(trace(start, 30, nobody, question).exact());
}

TEST_CASE("Boxes that straddle phidot = 0 are followed") {
    const auto box =
        with(with(typed("0.3", "0", "3", "-1"), Axis::phi, "0.3", "0.31"), Axis::phidot, "-0.01", "0.01");
    const Trace traced = trace(box, 0);
    CHECK(traced.exact());
    CHECK(traced.least == 2);
    REQUIRE(traced.widths);
    REQUIRE(traced.widths->natural);
    CHECK(traced.widths->correlated < *traced.widths->natural);
}

TEST_CASE("A box of mass ratios is followed") {
    const Trace traced = trace(with(typed("1/3", "1", "3", "-1/2"), Axis::ratio, "10", "10.01"), 0);
    CHECK(traced.exact());
    CHECK(traced.least == 1);
}

TEST_CASE("A box that splits has bounds, and says what its orbits share") {
    const auto box = with(typed("0", "0", "3", "-1"), Axis::phi, "-1", "1");
    const Trace traced = trace(box, 0);
    CHECK(!traced.exact());
    CHECK(traced.least == 1);  // it falls
    REQUIRE(traced.most);
    CHECK(*traced.most <= 7);
    CHECK(traced.collisions.empty());
}

TEST_CASE("Equal masses have at most two collisions, decided or not") {
    for (const int digits : {0, 40}) {
        const Trace corner = trace(typed("0", "0", "3", "-1", "1"), digits);
        CHECK(!corner.exact());
        CHECK(corner.most == 2);
        CHECK(trace(with(typed("0", "0", "3", "-1", "1"), Axis::phi, "-1", "1"), digits).most == 2);
    }
    CHECK(trace(typed("0", "0", "3", "-1", "1.001"), 0).most == 3);
}

TEST_CASE("More digits make the enclosures as narrow as asked for") {
    const Trace traced = trace(typed("1/3", "1", "3", "-1/2"), 60);
    CHECK(traced.exact());
    CHECK(traced.collisions[0].time.text.find("e-60") != std::string::npos);
    CHECK(traced.collisions[0].time.lo < traced.collisions[0].time.hi);
}

TEST_CASE("A start near a corner is decided with more digits only") {
    // Falls on both masses almost at once.
    const auto box = typed("1e-30", "0", "3", "-1");
    CHECK(!trace(box, 0).exact());
    CHECK(trace(box, 100).exact());
}

TEST_CASE("Angles too large to count their humps, and no numbers, lie on none in particular") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    CHECK(hump_of(Interval(4)) == 1);
    CHECK(hump_of(Interval(-1)) == -1);
    for (const double phi : {1e19, -1e300, inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK(hump_of(Interval(phi)) == 0);
        CHECK(way_out(Interval(phi), 0, flight::End::heavy, true) == Way::unknown);
    }
}

TEST_CASE("Starts that make no sense are refused in one line that names the quantity") {
    const auto refused = [](const Box& box, const std::string& word) {
        try {
            require_in_play(box);
            return false;
        } catch (const InputError& error) {
            const std::string text = error.what();
            INFO(text);
            CHECK(text.find('\n') == std::string::npos);
            return text.find(word) != std::string::npos;
        }
    };
    CHECK(refused(typed("0.3", "0", "3", "0"), "resting"));
    CHECK(refused(with(with(typed("0.3", "0", "3", "0"), Axis::phidot, "-1", "1"), Axis::ydot, "-1", "0"),
                  "resting"));
    CHECK(refused(typed("-1", "1", "0.1", "-1"), "light mass is below"));
    CHECK(refused(typed("1", "1", "0.01", "-1"), "heavy mass is below"));
    CHECK(refused(typed("1", "1", "-1", "-1"), "--y"));
    CHECK(refused(typed("0", "1", "0", "1"), "starts on the floor"));
    CHECK(refused(with(typed("0", "1", "0", "1"), Axis::y, "0", "1"), "part of the box"));
    CHECK(refused(with(typed("0", "1", "0.3", "1"), Axis::phi, "-1", "1"), "raise --y above 0.76"));
    // At q = 1 the light mass is below first, but the heavy one needs more.
    CHECK(refused(with(typed("0", "1", "0", "1", "1"), Axis::phi, "-0.2", "0.5"), "raise --y above 0.2397"));
    CHECK(refused(typed("0.5", "1", "0.01", "1", "1"), "suffices for both masses"));
    CHECK(refused(typed("5000", "1", "3", "-1"), "--phi"));
    CHECK(refused(typed("1", "1", "1e7", "-1"), "--y"));
    CHECK(refused(with(typed("0", "1", "3", "1"), Axis::phi, "0", "8"), "--phi"));
    CHECK_NOTHROW(require_in_play(typed("-1", "1", "0.77", "-1")));
}
