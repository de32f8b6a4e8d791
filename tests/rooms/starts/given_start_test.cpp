#include "starts/given_start.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/error.hpp"
#include "starts/argument.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using Catch::Matchers::Contains;

namespace {

// 60 decimals of pi, the last one cut off and rounded up.
const Rational below = parse_rational("3.141592653589793238462643383279502884197169399375105820974944");
const Rational above = parse_rational("3.141592653589793238462643383279502884197169399375105820974945");

Angle angle(const char* text) { return parse_angles("--phi", text).first; }

GivenStart by_heights(const char* heights, const Rational& q_lo, const Rational& q_hi, int bits = 128) {
    return read_start({.phi = "", .phidot = "1", .y = "", .ydot = "-1", .heights = heights}, q_lo, q_hi, "--",
                      bits);
}

std::string refused(const char* heights) {
    try {
        (void)by_heights(heights, 10, 10);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

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

TEST_CASE("heights are those that phi and y give back") {
    for (const char* heights : {"2.3,1.9", "1,2", "0.001,1", "1/3,1/7", "1.0000000000000001,2", "5,4"}) {
        for (const int q : {1, 10, 1000}) {
            CAPTURE(heights, q);
            const GivenStart start = by_heights(heights, q, q);
            const auto [light, heavy] = *start.meaning.heights;
            const double phi = start.box.lo[0].convert_to<double>();
            CHECK(std::cos(phi) >= 0);
            CHECK(std::sin(phi) == Approx((light - heavy).convert_to<double>()).epsilon(1e-15));
            CHECK(start.box.lo[2] == start.box.hi[2]);
            CHECK(start.box.lo[2] * (1 + q) == light + q * heavy);
            CHECK(start.box.hi[0] - start.box.lo[0] < exact(0x1p-120));
            CHECK(start.meaning.is_single);
        }
    }
    CHECK(by_heights("2,2", 10, 10).box.is_point());
    CHECK(by_heights("3,2", 10, 10).meaning.phi == Angle{0, Rational(1, 2)});
    CHECK(by_heights("2,3", 10, 10).meaning.phi == Angle{0, Rational(-1, 2)});
}

TEST_CASE("the bounds of an angle by heights contain it: asin 1/2 is pi/6") {
    const GivenStart start = by_heights("2,1.5", 10, 10);
    CHECK(start.box.lo[0] <= below / 6);
    CHECK(start.box.hi[0] >= above / 6);
    const GivenStart other = by_heights("1.5,2", 10, 10);
    CHECK(other.box.lo[0] <= -above / 6);
    CHECK(other.box.hi[0] >= -below / 6);
}

TEST_CASE("heights at a range of mass ratios are a box of the height of the centre of mass") {
    const GivenStart start = by_heights("2,1.5", 2, 3);
    CHECK(start.box.lo[2] == Rational(13, 8));
    CHECK(start.box.hi[2] == Rational(5, 3));
    CHECK_FALSE(start.meaning.is_single);
}

TEST_CASE("heights that no dumbbell in the air has are refused, with what is wrong") {
    CHECK_THAT(refused("2,1/2"), Contains("further apart than the rod is long"));
    CHECK_THAT(refused("1/2,-1/4"), Contains("the heavy mass is below the floor"));
    CHECK_THAT(refused("0,1/2"), Contains("the light mass touches the floor"));
    CHECK_THAT(refused("1e-100,1/2"), Contains("try --digits"));
    for (const char* wrong : {"", "1", "1,", ",1", "1,2,3", "1:2,1", "1;2", "pi,3"}) {
        CAPTURE(wrong);
        CHECK(refused(wrong) != "");
    }
}
