#include "starts/given/given_start.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "starts/given/argument.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

// 60 decimals of pi, the last one cut off and rounded up.
const Rational below = parse_rational("3.141592653589793238462643383279502884197169399375105820974944");
const Rational above = parse_rational("3.141592653589793238462643383279502884197169399375105820974945");

Angle angle(const char* text) { return parse_angles("--phi", text).first; }

}  // namespace

TEST_CASE("an angle is radians, degrees or a multiple of pi, exactly") {
    CHECK(angle("-1/3") == Angle{Rational(-1, 3), 0});
    CHECK(angle("30deg") == Angle{0, Rational(1, 6)});
    CHECK(angle("-22.5deg") == Angle{0, Rational(-1, 8)});
    CHECK(angle("pi") == Angle{0, 1});
    CHECK(angle("pi/2") == Angle{0, Rational(1, 2)});
    CHECK(angle("-2pi/3") == Angle{0, Rational(-2, 3)});
    CHECK(angle("0.3pi") == Angle{0, Rational(3, 10)});
    CHECK(angle("1e-2pi/0.5") == Angle{0, Rational(1, 50)});
    CHECK(angle("0pi").is_rational());
    CHECK(angle("180deg") == angle("pi"));
    for (const char* wrong :
         {"1/3pi", "pi/1/2", "pi/0", "pi2", "pipi", "degpi", "deg", "--pi", "30 deg", "30DEG", "+pi", "pi/-2",
          "pi:", ":pi", "pi:2pi:3pi", "2pi:pi", "3.15:pi", "nan", ""}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_angles("--phi", wrong), InputError);
    }
}

TEST_CASE("the bounds of a multiple of pi contain it, at any precision, and no more than that needs") {
    for (const int bits : {2, 53, 128, 190}) {
        const auto [lo, hi] = bounds(angle("-2pi/3"), bits);
        CAPTURE(bits);
        CHECK(lo <= -above * 2 / 3);
        CHECK(hi >= -below * 2 / 3);
        CHECK(hi - lo <= Rational(Integer(16), Integer(1) << static_cast<unsigned>(bits)));
    }
}

TEST_CASE("a range of angles is rounded outward, a single one is known exactly") {
    const GivenStart range =
        read_start({.phi = "pi/6:60deg", .phidot = "1", .y = "3", .ydot = "-1"}, 10, 10, "--", 128);
    CHECK(range.box.lo[0] <= below / 6);
    CHECK(range.box.hi[0] >= above / 3);
    CHECK_FALSE(range.meaning.is_single);
    CHECK_FALSE(range.meaning.phi);
    CHECK(range.meaning.rounded_phi == "pi/6:60deg");
    const GivenStart single =
        read_start({.phi = "pi/6", .phidot = "1", .y = "3", .ydot = "-1"}, 10, 10, "--", 128);
    CHECK(single.meaning.is_single);
    CHECK(single.meaning.phi == Angle{0, Rational(1, 6)});
    CHECK_FALSE(single.box.is_point());
    const GivenStart exact =
        read_start({.phi = "1/6", .phidot = "1", .y = "3", .ydot = "-1"}, 10, 10, "--", 128);
    CHECK(exact.box.is_point());
    CHECK(exact.meaning.rounded_phi.empty());
}
