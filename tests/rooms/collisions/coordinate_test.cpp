#include "collisions/coordinate.hpp"

#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

namespace {

bool same(const Interval& a, const Interval& b) { return a.lo() == b.lo() && a.hi() == b.hi(); }

void check_is(const Coordinate& x, const Rational& value) {
    CAPTURE(value);
    CHECK(Rational(x) == value);
    CHECK(same(x.enclosure<Interval>(), enclose<Interval>(value)));
    CHECK(approximate(x) == value.convert_to<double>());
    if (value > 0) {
        CHECK(same(x.inverse<Interval>(), enclose<Interval>(1 / value)));
    }
    const PrecisionScope scope(128);
    const auto wide = x.enclosure<BigInterval>();
    CHECK(exact_lo(wide) <= value);
    CHECK(value <= exact_hi(wide));
}

}  // namespace

TEST_CASE("a coordinate is the double or the rational that it was made of, and encloses it as tightly") {
    for (const double value : {0.0, 1.0, 3.0, 0.1, 0x1p-1000, 0x1p900}) {
        check_is(value, exact(value));
        check_is(exact(value), exact(value));
    }
    check_is(Rational(10, 3), Rational(10, 3));
    check_is(exact(1) + exact(0x1p-80), exact(1) + exact(0x1p-80));
}

TEST_CASE("middles are exact where no double is, too") {
    const auto check_middle = [](const Coordinate& a, const Coordinate& b) {
        check_is(middle(a, b), (Rational(a) + Rational(b)) / 2);
        CHECK(width(a, b) == (Rational(b) - Rational(a)).convert_to<double>());
    };
    check_middle(0.0, 2.0);
    check_middle(0.0, 0.0);
    check_middle(1.0, 1 + 0x1p-52);                                // one bit too many
    check_middle(0x1p-1070, 0x1p-1069);                            // subnormal
    check_middle(0x1.fffffffffffffp1023, 0x1.fffffffffffffp1023);  // the sum is too great
    check_middle(1.0, Rational(10, 3));
    check_middle(Rational(1, 3), Rational(2, 3));
}
