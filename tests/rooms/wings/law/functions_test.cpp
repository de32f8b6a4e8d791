#include "law/functions.hpp"

#include "catch.hpp"
#include "law/constants.hpp"
#include "number/rational.hpp"
#include "rooms/wings/law/direct.hpp"

using namespace dumbbell;
using namespace dumbbell::law;
using namespace dumbbell_test;

TEST_CASE("sinc is enclosed, narrowly") {
    for (const double x : {0.0, 1e-300, 1e-8, 0.05, 0.1, 0.1001, 0.7, 1.5, 2.16, 2.4}) {
        CAPTURE(x);
        const Interval found = sinc(Interval(x));
        CHECK(contains(found, x == 0 ? Real(1) : Real(sin(Real(x)) / Real(x))));
        CHECK(width(found) < 1e-14);
    }
    CHECK(contains(sinc(Interval(0.5, 1)), sin(Real(0.5)) / Real(0.5)));
    CHECK(contains(sinc(Interval(0.5, 1)), sin(Real(1))));
    CHECK(sinc(Interval(std::numeric_limits<double>::quiet_NaN())).is_nan());
}

TEST_CASE("the slope of a quantity is what it changes by per unit") {
    const Interval U(0.1, 0.3);
    const Slope u = line(U, Interval(0), Interval(1));
    const Slope x = sqrt(1 + sqr(u)) / (2 - u) - sinc_of(Interval(2), U) * cos_of(U);
    const auto value = [](const Real& at) {
        return Real(sqrt(1 + at * at) / (2 - at) -
                    (at == 0 ? Real(1) : Real(sin(2 * at) / (2 * at))) * cos(at));
    };
    CHECK(contains(x.at0, value(0)));
    CHECK(contains(x.first, Real(1) / 4));
    for (const double at : {0.1, 0.15, 0.2, 0.3}) {
        CAPTURE(at);
        CHECK(contains(x.range, value(at)));
        CHECK(contains(x.slope, (value(at) - value(0)) / Real(at)));
        CHECK(contains(x.second,
                       (value(at) - value(0) - Real(at) / 4) / (Real(at) * Real(at))));  // x'(0) = 1/4
    }
}

TEST_CASE("what lies in two enclosures lies in their common part, and of none there is nothing") {
    CHECK(common(Interval(0, 2), Interval(1, 3)).lo() == 1);
    CHECK(common(Interval(0, 2), Interval(1, 3)).hi() == 2);
    CHECK(common(Interval(0, 1), Interval(2, 3)).is_nan());
    CHECK_FALSE(within(common(Interval(0, 1), Interval(2, 3)), -10, 10));
}

TEST_CASE("the constants k0 and c0 are enclosed") {
    CHECK(contains(comparison_constant(), k0<Real>()));
    const PrecisionScope scope(200);
    const BigInterval c0 = correction_constant();
    CHECK(exact_lo(c0) <= parse_rational("0.20581158954949559533970656717"));
    CHECK(exact_hi(c0) >= parse_rational("0.20581158954949559533970656710"));
    CHECK(width(c0) < 1e-50);
}
